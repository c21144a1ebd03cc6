// SPDX-License-Identifier: MIT
// What grows on the graveyard, and the ground that it grows on.
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "scene/builtin/graveyard_parts.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

// Numbers in [0, 1), one after the other.
class Chance {
 public:
  explicit Chance(uint32_t seed) : seed_(seed) {}
  float unit() { return hash_unit(count_++, 0, seed_); }
  float between(float low, float high) { return low + (high - low) * unit(); }
  glm::vec3 direction() {
    const float y = between(-1, 1), turn = 2 * kPi * unit(), r = std::sqrt(1 - y * y);
    return {r * std::cos(turn), y, r * std::sin(turn)};
  }

 private:
  uint32_t seed_, count_ = 0;
};

constexpr int kLevels = 5;  // trunk, boughs … twigs
constexpr std::array<int, kLevels> kPoints{11, 7, 5, 4, 4}, kAround{14, 9, 6, 4, 3},
    kChildren{7, 5, 4, 2, 0};

struct Branch {
  glm::vec3 start, direction;
  float length_m, radius_m;
};

void add_branch(MeshBuilder& builder, const Branch& branch, int level, Chance& chance) {
  // Let it wander, up at first and with a droop at the twigs.
  const int count = kPoints[level];
  std::vector<glm::vec3> points{branch.start};
  std::vector<float> radius;
  glm::vec3 direction = branch.direction;
  const float step = branch.length_m / float(count - 1);
  for (int k = 0; k < count; ++k) {
    const float share = float(k) / float(count - 1);
    float r = branch.radius_m * (1.0f - 0.72f * share);
    if (level == 0) r += 0.9f * branch.radius_m * std::exp(-14.0f * share);  // the roots' flare
    radius.push_back(r);
    if (k == 0) continue;
    const float wander = level == 0 ? 0.16f : 0.30f;
    const float lift = level < 3 ? 0.10f : -0.04f;
    direction = glm::normalize(direction + wander * chance.direction() + glm::vec3(0, lift, 0));
    points.push_back(points.back() + direction * step);
  }
  add_tapered_tube(builder, points, radius, kAround[level]);
  if (level + 1 == kLevels) return;

  const int children = kChildren[level];
  const float turn0 = chance.between(0, 2 * kPi);
  for (int child = 0; child < children; ++child) {
    const float low = level == 0 ? 0.38f : 0.25f;
    const float share = low + (0.97f - low) * (float(child) + chance.unit()) / float(children);
    const float at = share * float(count - 1);
    const int k = std::min(int(at), count - 2);
    const glm::vec3 place = glm::mix(points[k], points[k + 1], at - float(k));
    const glm::vec3 along = glm::normalize(points[k + 1] - points[k]);

    // Spread the children around, by the golden angle.
    const glm::vec3 side = glm::normalize(
        glm::cross(along, std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    const float turn = turn0 + 2.4f * float(child);
    const glm::vec3 away = side * std::cos(turn) + glm::cross(along, side) * std::sin(turn);
    const float spread = chance.between(0.65f, 1.05f);
    const glm::vec3 out = along * std::cos(spread) + away * std::sin(spread);
    add_branch(builder,
               {place, out, branch.length_m * chance.between(0.50f, 0.70f) * (1.15f - 0.5f * share),
                branch.radius_m * (1.0f - 0.72f * share) * chance.between(0.55f, 0.72f)},
               level + 1, chance);
  }
}

}  // namespace

void add_tree(MeshBuilder& builder, const GraveyardMaterials& m, uint32_t seed) {
  builder.set_material(m.bark, 0.8f);
  Chance chance(seed);
  add_branch(
      builder,
      {{0, -0.35f, 0}, glm::normalize(glm::vec3(chance.between(-0.2f, 0.2f), 1, 0)), 5.4f, 0.24f},
      0, chance);
}

float path_center(float z) {
  return -0.5f + 0.13f * z + 0.5f * std::sin(0.45f * z);
}

float ground_height(float x, float z) {
  const glm::vec2 uv((x + 16.0f) / 32.0f, (z + 16.0f) / 32.0f);
  const float hills = 0.75f * (tiling_noise(uv, 5, 3, 131) - 0.5f);
  const float lumps = 0.10f * (tiling_noise(uv, 28, 3, 132) - 0.5f);

  // The path is trodden in; the crypt stands on level ground.
  const float off_path = std::abs(x - path_center(z));
  const float path = glm::smoothstep(1.6f, 0.5f, off_path);
  const float crypt = glm::smoothstep(6.0f, 3.2f, glm::length(glm::vec2(x + 1.9f, z + 8.2f)));
  return (hills * (1.0f - crypt) + lumps) * (1.0f - 0.55f * path) - 0.10f * path;
}

void add_ground(MeshBuilder& builder, const GraveyardMaterials& m) {
  constexpr int kAcross = 96, kDeep = 86;
  constexpr float kBottom = -1.5f;
  builder.set_material(m.earth, 2.2f);
  const auto place = [](int i, int j) {
    const float x = mix_exact({-kGroundHalfWidth, 0, 0}, {kGroundHalfWidth, 0, 0}, i, kAcross).x;
    const float z = mix_exact({0, 0, kGroundFront}, {0, 0, kGroundBack}, j, kDeep).z;
    return glm::vec3(x, ground_height(x, z), z);
  };
  builder.add_grid(kAcross, kDeep, [&](int i, int j) {
    const glm::vec3 p = place(i, j);
    constexpr float kStep = 0.05f;
    const glm::vec3 normal(ground_height(p.x - kStep, p.z) - ground_height(p.x + kStep, p.z),
                           2 * kStep,
                           ground_height(p.x, p.z - kStep) - ground_height(p.x, p.z + kStep));
    return SurfacePoint{p, normal, {p.x, p.z}};
  });

  // Close it below: four sides and a floor over the same rim.
  const auto rim = [&](int k) {
    if (k < kAcross) return place(k, 0);
    if (k < kAcross + kDeep) return place(kAcross, k - kAcross);
    if (k < 2 * kAcross + kDeep) return place(2 * kAcross + kDeep - k, kDeep);
    return place(0, (2 * (kAcross + kDeep) - k) % (2 * (kAcross + kDeep)));
  };
  constexpr int kRim = 2 * (kAcross + kDeep);
  const auto low = [&](int k) {
    const glm::vec3 p = rim(k % kRim);
    return glm::vec3(p.x, kBottom, p.z);
  };
  const int sides[5] = {0, kAcross, kAcross + kDeep, 2 * kAcross + kDeep, kRim};
  constexpr glm::vec3 kOut[4] = {{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}};
  for (int side = 0; side < 4; ++side)
    builder.add_grid(sides[side + 1] - sides[side], 1, [&](int i, int j) {
      const int k = (sides[side] + i) % kRim;
      const glm::vec3 p = j == 0 ? low(k) : rim(k);
      return SurfacePoint{p, kOut[side], planar_uv(p, kOut[side])};
    });
  builder.add_fan({0, kBottom, 0.5f * (kGroundBack + kGroundFront)}, kRim,
                  [&](int k) { return low(kRim - k); }, {0, -1, 0});
}

void add_path(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.granite, 1.3f);
  Chance chance(141);
  for (float z = 9.5f; z > -5.0f;) {
    const float length = chance.between(0.42f, 0.62f);
    const float middle = path_center(z - 0.5f * length);
    float x = middle - 0.75f + chance.between(-0.1f, 0.1f);
    while (x < middle + 0.6f) {
      const float width = chance.between(0.40f, 0.72f);
      const float y = ground_height(x + 0.5f * width, z - 0.5f * length) + 0.035f;
      const float drop = chance.between(0.0f, 0.02f), in = chance.between(0.02f, 0.05f);
      add_bevelled_box(builder, {x, y - 0.2f, z - length + in}, {x + width - in, y - drop, z},
                       0.022f);
      x += width;
    }
    z -= length;
  }
}

void add_grass_tuft(MeshBuilder& builder, const GraveyardMaterials& m, glm::vec3 place,
                    uint32_t seed) {
  builder.set_material(m.grass);
  Chance chance(seed);
  for (int blade = 0; blade < 11; ++blade) {
    const glm::vec3 lean = glm::vec3(chance.between(-1, 1), 0, chance.between(-1, 1));
    const glm::vec3 foot =
        place + 0.13f * glm::vec3(chance.between(-1, 1), 0, chance.between(-1, 1));
    const float height = chance.between(0.10f, 0.30f);
    add_tapered_tube(
        builder,
        {foot - glm::vec3(0, 0.04f, 0), foot + glm::vec3(0, 0.55f * height, 0) + 0.03f * lean,
         foot + glm::vec3(0, height, 0) + 0.12f * lean},
        {0.008f, 0.006f}, 3);
  }
}

}  // namespace lueur::builtin
