// SPDX-License-Identifier: MIT
// Slices against quadrature in double precision.
#include "techniques/baselines/slice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lueur {
namespace {

constexpr double kPi = std::numbers::pi;

double weight_at(double h, double normal_rad) {
  return std::abs(std::sin(h)) * std::max(std::cos(h - normal_rad), 0.0);
}

double quadrature(double from, double to, double normal_rad) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    sum += weight_at(from + (to - from) * (i + 0.5) / kSteps, normal_rad);
  return sum * (to - from) / kSteps;
}

const vec3 kPosition(1.5f, -0.5f, -2.0f);
const vec2 kRayScale(0.01f, -0.012f);
vec3 normal_at(double theta, double phi) {
  return {static_cast<float>(std::sin(theta) * std::cos(phi)),
          static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta))};
}

TEST(Slices, SharesAreTheWeightsBelowAnAngle) {
  for (const double theta : {0.0, 0.4, 1.1}) {
    for (const vec2 line : {vec2(1, 0), vec2(-0.6f, 0.8f), vec2(0, -1)}) {
      const Slice s = slice_of(kPosition, normal_at(theta, 0.7), line, kRayScale);
      const double gamma = s.normal_rad, low = gamma - kPi / 2;
      const double whole = quadrature(low, low + kPi, gamma);
      EXPECT_NEAR(s.range, whole, 1e-4);
      for (const double h : {-1.4, -0.6, -0.01, 0.3, 1.0, 1.5}) {
        const double inside = std::clamp(h, low, low + kPi);
        EXPECT_NEAR(share_below(s, static_cast<float>(h)), quadrature(low, inside, gamma) / whole,
                    1e-4)
            << theta << ", " << h;
      }
      EXPECT_EQ(share_below(s, -4.0f), 0.0f);
      EXPECT_EQ(share_below(s, 4.0f), 1.0f);
    }
  }
}

// Light of 1 from the whole hemisphere is 1, wherever the normal points that the eye sees.
TEST(Slices, WeightsAddUpToTheHemisphere) {
  constexpr uint kCount = 720;
  for (const double theta : {0.0, 0.5, 1.0}) {
    const vec3 normal = normal_at(theta, 2.0);
    ASSERT_GT(-dot(normal, kPosition), 0.0f);
    double sum = 0;
    for (uint k = 0; k < kCount; ++k)
      sum += slice_of(kPosition, normal, slice_direction(k, kCount, 0.5f), kRayScale).weight;
    EXPECT_NEAR(sum / kCount, 1.0, 1e-4) << theta;
  }
}

TEST(Slices, AnglesLieInTheirPlane) {
  const vec2 line(0.6f, 0.8f);
  const Slice s = slice_of(kPosition, {0, 0, 1}, line, kRayScale);
  EXPECT_NEAR(length(s.along), 1.0f, 1e-6f);
  EXPECT_NEAR(dot(s.along, s.to_eye), 0.0f, 1e-6f);
  EXPECT_NEAR(slice_angle(s, s.to_eye), 0.0f, 1e-6f);
  EXPECT_NEAR(slice_angle(s, s.along), kPi / 2, 1e-6);
  EXPECT_NEAR(slice_angle(s, s.along + s.to_eye), kPi / 4, 1e-6);
  EXPECT_NEAR(slice_angle(s, s.to_eye - s.along), -kPi / 4, 1e-6);
  // What is seen a step further is in the plane.
  const vec3 seen =
      3.0f * vec3(vec2(kPosition) / 2.0f + 40.0f * line * kRayScale, -1.0f) - kPosition;
  EXPECT_NEAR(dot(seen, cross(s.to_eye, s.along)), 0.0f, 1e-6f);
  EXPECT_GT(slice_angle(s, seen), 0.0f);
}

TEST(Slices, SamplesStayBetweenThePixelAndTheReach) {
  for (const float reach : {0.5f, 3.0f, 100.0f}) {
    float last = 0;
    for (uint i = 0; i < 8; ++i) {
      const float offset = sample_offset_px(i, 8, 0.25f, reach);
      EXPECT_GE(offset, std::max(last, 1.0f));
      EXPECT_LE(offset, std::max(reach, 1.0f));
      last = offset;
    }
  }
  const vec2 right(1, 0), down(0, 1), extent(100, 50), at(30.5f, 20.5f);
  EXPECT_NEAR(reach_px(at, right, extent, 2, 4, {0.1f, 0}), 5.0f, 1e-4f);
  EXPECT_NEAR(reach_px(at, right, extent, 200, 4, {0.1f, 0}), 69.5f, 1e-3f);
  EXPECT_NEAR(reach_px(at, -right, extent, 200, 4, {0.1f, 0}), 30.5f, 1e-3f);
  EXPECT_NEAR(reach_px(at, down, extent, 200, 4, {0.1f, 0}), 29.5f, 1e-3f);
}

// 9 x 9 pixels together must be spread evenly, and each 3 x 3 of them nearly.
TEST(Slices, NeighboursInterleave) {
  for (const uint seed : {0u, 5u}) {
    std::vector<float> shifts, turns;
    for (uint y = 0; y < 9; ++y) {
      for (uint x = 0; x < 9; ++x) {
        const vec2 start = slice_start(uvec2(x + 18, y + 4), seed, 1);
        shifts.push_back(start.x);
        turns.push_back(start.y);
      }
    }
    for (auto* list : {&shifts, &turns}) {
      std::sort(list->begin(), list->end());
      for (size_t i = 1; i < 81; ++i) EXPECT_NEAR((*list)[i] - (*list)[i - 1], 1.0f / 81, 1e-4f);
    }
  }
}

TEST(Slices, APlaneMeetsTheLine) {
  const vec3 n = normalize(vec3(0.2f, 0.9f, 0.3f));
  const vec3 point(0.1f, -1.0f, -3.0f);
  const auto z_at = [&](vec2 ray) { return dot(n, point) / dot(n, vec3(ray, -1)); };
  const vec2 q(0.02f, -0.4f), off(0.025f, -0.39f);
  EXPECT_NEAR(z_on_line(vec4(n, z_at(q)), q, off), z_at(off), 1e-5f);
  // Seen from behind, or nearly edge-on, the pixel's own z is what there is.
  EXPECT_EQ(z_on_line(vec4(-n, 3.0f), q, off), 3.0f);
  EXPECT_EQ(z_on_line(vec4(0, 1, 0, 3), {0, -0.4f}, {0, -0.001f}), 6.0f);
}

}  // namespace
}  // namespace lueur
