// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/dragon.h"
#include "scene/builtin/sdf.h"

namespace lueur::builtin {
namespace {

using glm::vec3;

// A rod through `points` that tapers from the first to the last.
template <size_t N>
float horn(vec3 p, const std::array<vec3, N>& points, float thick, float thin) {
  float nearest = 1e9f;
  const auto radius = [&](size_t k) { return glm::mix(thick, thin, float(k) / float(N - 1)); };
  for (size_t k = 0; k + 1 < N; ++k)
    nearest = std::min(nearest, sdf::cone(p, points[k], points[k + 1], radius(k), radius(k + 1)));
  return nearest;
}

// Distance to a flat triangle.
float triangle(vec3 p, vec3 a, vec3 b, vec3 c) {
  const vec3 normal = glm::normalize(glm::cross(b - a, c - a));
  const auto within = [&](vec3 from, vec3 to) {
    return glm::dot(glm::cross(normal, to - from), p - from) >= 0.0f;
  };
  if (within(a, b) && within(b, c) && within(c, a)) return std::abs(glm::dot(p - a, normal));
  return std::min({sdf::capsule(p, a, b, 0), sdf::capsule(p, b, c, 0), sdf::capsule(p, c, a, 0)});
}

}  // namespace

float dragon_head(vec3 p) {
  p.x = std::abs(p.x);

  // Skull, snout with its nose, cheeks and brows.
  float d = sdf::ellipsoid(p, {0, 0, -0.02f}, {0.078f, 0.068f, 0.105f});
  d = sdf::smooth_min(d, sdf::cone(p, {0, -0.005f, 0.04f}, {0, -0.018f, 0.19f}, 0.056f, 0.040f),
                      0.05f);
  d = sdf::smooth_min(d, sdf::sphere(p, {0.026f, 0.006f, 0.205f}, 0.024f), 0.02f);
  d = sdf::smooth_min(d, sdf::capsule(p, {0, 0.035f, 0.08f}, {0, 0.02f, 0.19f}, 0.012f), 0.02f);
  d = sdf::smooth_min(d, sdf::ellipsoid(p, {0.062f, -0.03f, -0.01f}, {0.035f, 0.04f, 0.06f}),
                      0.03f);
  d = sdf::smooth_max(d, -sdf::sphere(p, {0.064f, 0.028f, 0.062f}, 0.030f), 0.012f);
  d = sdf::smooth_min(
      d, sdf::cone(p, {0.028f, 0.048f, 0.10f}, {0.088f, 0.066f, 0.005f}, 0.014f, 0.020f), 0.015f);
  d = sdf::smooth_max(d, -sdf::sphere(p, {0.030f, 0.012f, 0.233f}, 0.012f), 0.008f);

  // The open jaw, its tongue and the teeth.
  float jaw = sdf::cone(p, {0, -0.055f, -0.01f}, {0, -0.098f, 0.155f}, 0.042f, 0.024f);
  jaw = sdf::smooth_max(
      jaw, -sdf::cone(p, {0, -0.005f, 0.01f}, {0, -0.062f, 0.17f}, 0.030f, 0.026f), 0.012f);
  d = sdf::smooth_min(d, jaw, 0.02f);
  d = std::min(d, sdf::cone(p, {0, -0.062f, 0.03f}, {0, -0.085f, 0.165f}, 0.016f, 0.012f));
  d = std::min(d,
               sdf::cone(p, {0.029f, -0.035f, 0.195f}, {0.030f, -0.082f, 0.190f}, 0.012f, 0.003f));
  d = std::min(d,
               sdf::cone(p, {0.040f, -0.035f, 0.13f}, {0.040f, -0.068f, 0.128f}, 0.011f, 0.003f));
  d = std::min(d,
               sdf::cone(p, {0.018f, -0.088f, 0.158f}, {0.020f, -0.048f, 0.165f}, 0.010f, 0.003f));
  d = std::min(d, sdf::sphere(p, {0.060f, 0.026f, 0.058f}, 0.022f));  // the eye

  // Horns, the frill behind the jaw, a beard.
  d = sdf::smooth_min(d,
                      horn<5>(p,
                              {vec3(0.042f, 0.05f, -0.05f), vec3(0.070f, 0.115f, -0.115f),
                               vec3(0.098f, 0.150f, -0.195f), vec3(0.108f, 0.190f, -0.270f),
                               vec3(0.098f, 0.250f, -0.320f)},
                              0.028f, 0.005f),
                      0.02f);
  const std::array<std::array<vec3, 2>, 3> kFrill = {
      {{vec3(0.07f, 0.02f, -0.05f), vec3(0.165f, 0.05f, -0.15f)},
       {vec3(0.07f, -0.02f, -0.04f), vec3(0.165f, -0.03f, -0.13f)},
       {vec3(0.06f, -0.06f, -0.02f), vec3(0.130f, -0.105f, -0.09f)}}};
  for (const auto& spike : kFrill)
    d = sdf::smooth_min(d, sdf::cone(p, spike[0], spike[1], 0.022f, 0.005f), 0.02f);
  return sdf::smooth_min(d, sdf::cone(p, {0, -0.105f, 0.12f}, {0, -0.175f, 0.10f}, 0.016f, 0.004f),
                         0.015f);
}

float dragon_wings(vec3 p) {
  p.x = std::abs(p.x);
  const float far = sdf::box(p, {0.36f, 0.71f, -0.34f}, {0.34f, 0.38f, 0.18f});
  if (far > 0.1f) return far;
  constexpr vec3 kShoulder{0.05f, 0.47f, -0.20f}, kElbow{0.19f, 0.70f, -0.33f};
  constexpr vec3 kWrist{0.30f, 0.97f, -0.26f}, kRoot{0.07f, 0.36f, -0.30f};
  constexpr std::array<vec3, 4> kTips = {{{0.64f, 1.04f, -0.44f},
                                          {0.67f, 0.75f, -0.48f},
                                          {0.54f, 0.51f, -0.46f},
                                          {0.33f, 0.40f, -0.42f}}};

  // The skin between the fingers, cut out in arcs at its edge.
  constexpr float kHalfThickness = 0.009f;
  float skin = 1e9f;
  for (size_t k = 0; k + 1 < kTips.size(); ++k)
    skin = std::min(skin, triangle(p, kWrist, kTips[k], kTips[k + 1]));
  skin = std::min({skin, triangle(p, kWrist, kTips[3], kElbow),
                   triangle(p, kElbow, kTips[3], kRoot), triangle(p, kElbow, kRoot, kShoulder)});
  skin -= kHalfThickness;
  const auto cut = [&](vec3 a, vec3 b, vec3 from) {
    const vec3 middle = 0.5f * (a + b), out = glm::normalize(middle - from);
    const float half = 0.5f * glm::distance(a, b), back = 1.1f * half;
    const float radius = std::sqrt(half * half + back * back);
    skin = sdf::smooth_max(skin, radius - glm::distance(p, middle + out * back), 0.008f);
  };
  for (size_t k = 0; k + 1 < kTips.size(); ++k) cut(kTips[k], kTips[k + 1], kWrist);
  cut(kTips[3], kRoot, kElbow);

  // The arm, and fingers that stand out of the skin.
  float bone = sdf::cone(p, kShoulder, kElbow, 0.038f, 0.026f);
  bone = sdf::smooth_min(bone, sdf::cone(p, kElbow, kWrist, 0.026f, 0.022f), 0.02f);
  for (const vec3 tip : kTips)
    bone = sdf::smooth_min(bone, sdf::cone(p, kWrist, tip, 0.018f, 0.009f), 0.015f);
  bone = sdf::smooth_min(bone, sdf::cone(p, kWrist, {0.27f, 1.06f, -0.20f}, 0.018f, 0.004f), 0.02f);
  return sdf::smooth_min(skin, bone, 0.012f);
}

}  // namespace lueur::builtin
