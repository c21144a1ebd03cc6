// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/basket.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

constexpr int kStakes = 28;  // even, so that the weave closes
constexpr int kCellsAStake = 6;
constexpr int kRows = 13;
constexpr int kCellsARow = 6;
constexpr int kAround = kStakes * kCellsAStake;

float basket_radius(float share) {
  return 0.36f + (kBasketRadius - 0.36f) * share + 0.035f * std::sin(kPi * share);
}

// Half a circle over [0, 1].
float round_strand(float share) {
  return std::sqrt(std::max(0.0f, 4.0f * share * (1.0f - share)));
}

// Radius where `stakes` stakes have passed around and `rows` rows up: the strand's weave, or the
// stake that it lets show.
float woven_radius(float stakes, float rows) {
  const float plain = basket_radius(rows / kRows);
  const int row = std::min(int(rows), kRows - 1);
  const float over = std::cos(kPi * (stakes + float(row)));  // 1 in front of a stake, -1 behind
  const float strand = (0.014f * over + 0.010f) * round_strand(rows - float(row));
  const float from_stake = stakes - std::round(stakes);  // -0.5 … 0.5
  const float stake = 0.011f * round_strand(std::clamp(0.5f + 2.2f * from_stake, 0.0f, 1.0f)) *
                      std::min(1.0f, 4.0f * std::min(rows, kRows - rows));
  return plain + std::max(strand, stake);
}

glm::vec3 woven_point(int i, float stakes, float rows) {
  const float radius = woven_radius(stakes, rows);
  const glm::vec2 c = i >= 0 ? unit_circle_point(i, kAround)
                             : glm::vec2(std::cos(2 * kPi * stakes / kStakes),
                                         std::sin(2 * kPi * stakes / kStakes));
  return {radius * c.x, kBasketHeight * rows / kRows, -radius * c.y};
}

void add_side(MeshBuilder& builder) {
  builder.add_grid(kAround, kRows * kCellsARow, [](int i, int j) {
    const float stakes = float(i % kAround) / kCellsAStake, rows = float(j) / kCellsARow;
    const float h = 0.06f;
    const glm::vec3 along = woven_point(-1, stakes + h, rows) - woven_point(-1, stakes - h, rows);
    const glm::vec3 up = woven_point(-1, stakes, std::min(rows + h, float(kRows))) -
                         woven_point(-1, stakes, std::max(rows - h, 0.0f));
    return SurfacePoint{
        woven_point(i, stakes, rows),
        glm::cross(along, up),
        {2 * kPi * kBasketRadius * float(i) / kAround, -kBasketHeight * rows / kRows}};
  });
}

glm::vec3 ring_point(int i, float radius, float height) {
  const glm::vec2 c = unit_circle_point(i, kAround);
  return {radius * c.x, height, -radius * c.y};
}

}  // namespace

void add_wicker(MeshBuilder& builder, int32_t wicker, int32_t soil) {
  constexpr float kInner = kBasketRadius - 0.035f, kSoil = kBasketHeight - 0.06f;
  builder.set_material(wicker, 0.5f);
  add_side(builder);
  builder.add_fan({0, 0, 0}, kAround,
                  [](int k) { return ring_point(kAround - k, basket_radius(0), 0); }, {0, -1, 0});
  builder.add_grid(kAround, 1, [](int i, int j) {
    const glm::vec3 p = ring_point(i, j == 0 ? basket_radius(1) : kInner, kBasketHeight);
    return SurfacePoint{p, {0, 1, 0}, planar_uv(p, {0, 1, 0})};
  });
  builder.add_grid(kAround, 1, [](int i, int j) {
    const glm::vec3 p = ring_point(i, kInner, j == 0 ? kBasketHeight : kSoil);
    return SurfacePoint{p, {-p.x, 0, -p.z}, {-p.x, -p.y}};
  });
  builder.set_material(soil, 0.5f);
  builder.add_fan({0, kSoil, 0}, kAround, [](int k) { return ring_point(k, kInner, kSoil); },
                  {0, 1, 0});

  // Twist two strands around the rim, and put a ring through each side as a handle.
  builder.set_material(wicker, 0.5f);
  for (const float phase : {0.0f, kPi}) {
    const auto strand = [=](float t) {
      const float around = 2 * kPi * t, twist = 2 * kPi * 22.0f * t + phase;
      const float radius = kBasketRadius - 0.012f + 0.017f * std::cos(twist);
      return glm::vec3(radius * std::cos(around), kBasketHeight + 0.004f + 0.017f * std::sin(twist),
                       -radius * std::sin(around));
    };
    add_closed_tube(builder, strand, 0.0175f, 330, 8);
  }
  for (const float side : {-1.0f, 1.0f}) {
    const auto ring = [=](float t) {
      const float a = 2 * kPi * t;
      return glm::vec3(side * (kBasketRadius + 0.02f + 0.035f * std::sin(a)),
                       kBasketHeight - 0.05f + 0.11f * std::sin(a), 0.13f * std::cos(a));
    };
    add_closed_tube(builder, ring, 0.017f, 48, 10);
  }
}

void add_foliage(MeshBuilder& builder, const Foliage& foliage) {
  for (int k = 0; k < foliage.count; ++k) {
    const auto random = [&](uint32_t n) { return hash_unit(uint32_t(k), n, foliage.seed); };

    // Spread the leaves by the golden angle, the steep ones in the middle.
    const float share = (float(k) + 0.5f) / float(foliage.count);
    const float angle = 2.399963f * float(k) + 0.4f * (random(0) - 0.5f);
    const float length = foliage.length_m * (0.65f + 0.35f * random(1));
    const float width = foliage.width_m * (0.75f + 0.5f * random(2));
    const float lift = foliage.rise * (1.35f - 0.85f * share) + 0.25f * (random(3) - 0.5f);
    const glm::vec3 out(std::cos(angle), 0, std::sin(angle)), across(out.z, 0, -out.x);
    const glm::vec3 base =
        out * (0.04f + 0.20f * share * foliage.length_m) + glm::vec3(0, foliage.height_m, 0);
    const float droop = 0.45f + 0.45f * random(4);
    const auto middle = [=](float u, float v) {
      const float half = 0.5f * width * std::pow(std::sin(kPi * (0.06f + 0.90f * v)), 0.75f);
      const float side = 2.0f * u - 1.0f;
      const glm::vec3 spine = out * (length * v * (1.0f - 0.15f * v)) +
                              glm::vec3(0, length * (lift * v - droop * v * v), 0);
      return base + spine + across * (half * side) + glm::vec3(0, 0.35f * half * side * side, 0);
    };
    add_cloth(builder, middle, {width, length}, 0.004f, 4, 9);
  }
}

void add_blossom(MeshBuilder& builder, glm::vec3 center, float radius_m) {
  add_sphere(builder, center, radius_m, 18, [](glm::vec3 d) {
    const float petals = 0.80f + 0.20f * std::cos(6.0f * std::atan2(d.z, d.x));
    return glm::mix(1.0f, petals, std::sqrt(std::max(0.0f, 1.0f - d.y * d.y))) *
           (1.0f - 0.45f * d.y * d.y);
  });
}

void add_clay_pot(MeshBuilder& builder, int32_t clay, int32_t soil, float height_m) {
  const Tessellation tessellation{0.06f};
  const float h = height_m, r = 0.42f * height_m;
  builder.set_material(clay, 0.6f);
  Profile side({0, 0}, tessellation);
  side.line_to({0.66f * r, 0})
      .arc_to({0.70f * r, 0.02f * h}, kPi / 2, 2)
      .line_to({0.93f * r, 0.78f * h})
      .arc_to({1.05f * r, 0.80f * h}, -0.8f, 2)
      .line_to({1.09f * r, 0.97f * h})
      .arc_to({1.03f * r, h}, kPi / 2, 3)
      .arc_to({0.93f * r, 0.97f * h}, kPi / 2, 3)
      .line_to({0.91f * r, 0.88f * h});
  add_lathe(builder, side, 48);
  builder.set_material(soil, 0.5f);
  Profile top({0.91f * r, 0.88f * h}, tessellation);
  top.line_to({0, 0.90f * h});
  add_lathe(builder, top, 48);
}

}  // namespace lueur::builtin
