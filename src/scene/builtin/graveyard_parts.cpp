// SPDX-License-Identifier: MIT
// What was built on the graveyard: crypt, brick wall, fence and lantern.
#include "scene/builtin/graveyard_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/builtin/arcade.h"
#include "scene/builtin/isosurface.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/sdf.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

const Tessellation kCoarse{0.6f}, kFine{0.1f};

glm::mat4 moved(glm::vec3 by) {
  return glm::translate(glm::mat4(1.0f), by);
}

void add_crypt_column(MeshBuilder& builder, float x) {
  builder.set_transform(moved({x, 0, 1.98f}));
  add_bevelled_box(builder, {-0.24f, 0.34f, -0.24f}, {0.24f, 0.50f, 0.24f}, 0.02f);
  Profile shaft({0, 0.48f}, Tessellation{0.5f});
  shaft.line_to({0.22f, 0.48f})
      .arc_to({0.19f, 0.60f}, 2.4f, 5)
      .arc_to({0.155f, 0.68f}, -1.4f, 3)
      .arc_to({0.13f, 2.55f}, 0.05f, 3)
      .arc_to({0.21f, 2.78f}, -1.3f, 5)
      .line_to({0, 2.78f});
  add_lathe(builder, shaft, 24);
  add_bevelled_box(builder, {-0.25f, 2.76f, -0.25f}, {0.25f, 2.99f, 0.25f}, 0.02f);
  builder.set_transform(glm::mat4(1.0f));
}

// Gable and the two sides of the roof, over walls that end at 3.2 m.
void add_crypt_roof(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.stone, 1.6f);
  add_bevelled_box(builder, {-2.30f, 2.98f, -1.95f}, {2.30f, 3.12f, 2.35f}, 0.03f);
  add_bevelled_box(builder, {-2.45f, 3.11f, -2.05f}, {2.45f, 3.28f, 2.50f}, 0.05f);
  Profile gable({-2.3f, 3.26f}, kCoarse);
  gable.line_to({2.3f, 3.26f}).line_to({0, 4.36f}).line_to({-2.3f, 3.26f});
  add_sweep(builder, gable, {0, 3.6f}, 1, [](int k) {
    return SweepFrame{{0, 0, k == 0 ? 2.28f : -1.9f}, {1, 0, 0}, {0, 1, 0}};
  });
  builder.set_material(m.granite, 1.6f);
  const float slope = std::atan2(1.10f, 2.3f), length = 2.82f;
  for (const float side : {-1.0f, 1.0f}) {
    builder.set_transform(
        glm::rotate(moved({side * 1.26f, 3.86f, 0}), -side * slope, glm::vec3(0, 0, 1)));
    add_bevelled_box(builder, {-0.5f * length, -0.07f, -2.1f}, {0.5f * length, 0.07f, 2.52f},
                     0.03f);
  }

  // A cross on the ridge.
  builder.set_material(m.stone, 1.6f);
  builder.set_transform(moved({0, 4.36f, 2.1f}));
  add_bevelled_box(builder, {-0.2f, -0.1f, -0.2f}, {0.2f, 0.16f, 0.2f}, 0.03f);
  const float arm = 0.07f, reach = 0.28f;
  Profile cross({-arm, 0.1f}, kCoarse);
  for (const glm::vec2 p : {glm::vec2(arm, 0.1f),
                            {arm, 0.55f},
                            {reach, 0.55f},
                            {reach, 0.69f},
                            {arm, 0.69f},
                            {arm, 0.98f},
                            {-arm, 0.98f},
                            {-arm, 0.69f},
                            {-reach, 0.69f},
                            {-reach, 0.55f},
                            {-arm, 0.55f},
                            {-arm, 0.1f}})
    cross.line_to(p);
  add_plate(builder, cross, {0, 0.62f}, 0.14f, 0.02f);
  builder.set_transform(glm::mat4(1.0f));
}

// Iron bars in a frame, one leaf of the door, hung at x = 0 towards +x.
void add_door_leaf(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.iron);
  for (const float y : {0.05f, 0.8f, 1.55f})
    add_box(builder, {0, y, -0.015f}, {0.58f, y + 0.05f, 0.015f}, kCoarse);
  for (int k = 0; k < 6; ++k) {
    const float x = 0.02f + 0.108f * float(k);
    add_box(builder, {x - 0.013f, 0, -0.013f}, {x + 0.013f, 1.75f, 0.013f}, kCoarse);
  }
}

// The outline of one fence rod with its spear head.
Profile rod_profile() {
  Profile rod({0, -0.2f}, kCoarse);
  rod.line_to({0.013f, -0.2f})
      .line_to({0.013f, 1.24f})
      .line_to({0.028f, 1.26f})
      .line_to({0.014f, 1.29f})
      .line_to({0.034f, 1.35f})
      .line_to({0, 1.49f});
  return rod;
}

}  // namespace

void add_crypt(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.granite, 1.5f);
  for (int step = 0; step < 3; ++step) {
    const float top = 0.12f * float(step + 1), in = 0.26f * float(step);
    add_bevelled_box(builder, {-2.95f + in, -0.8f, -2.4f + in}, {2.95f - in, top, 3.0f - in},
                     0.02f);
  }
  builder.set_material(m.stone, 1.6f);
  const ArcadeWall front{-2.0f, 2.0f, 0.34f, 1.75f, 3.0f, 1.35f, 1.70f, {{0.0f, 0.62f}}};
  add_arcade_wall(builder, front, kCoarse);
  add_archivolts(builder, front, Tessellation{0.2f});
  for (const float side : {-1.0f, 1.0f})
    add_box(builder, {std::min(side * 2.0f, side * 1.7f), 0.34f, -1.7f},
            {std::max(side * 2.0f, side * 1.7f), 3.0f, 1.36f}, kCoarse);
  add_box(builder, {-1.71f, 0.34f, -1.7f}, {1.71f, 3.0f, -1.4f}, kCoarse);
  for (const float x : {-1.5f, 1.5f}) add_crypt_column(builder, x);
  add_crypt_roof(builder, m);

  // Both leaves of the door stand open; a chest lies behind them.
  for (const float side : {-1.0f, 1.0f}) {
    builder.set_transform(glm::rotate(moved({side * 0.60f, 0.36f, 1.50f}),
                                      side < 0 ? -1.1f : kPi + 1.35f, glm::vec3(0, 1, 0)));
    add_door_leaf(builder, m);
  }
  builder.set_transform(moved({0, 0.36f, -0.45f}));
  builder.set_material(m.stone, 1.4f);
  add_bevelled_box(builder, {-0.85f, -0.02f, -0.40f}, {0.85f, 0.60f, 0.40f}, 0.03f);
  add_bevelled_box(builder, {-0.98f, 0.58f, -0.52f}, {0.98f, 0.72f, 0.52f}, 0.04f);
  builder.set_transform(glm::mat4(1.0f));
}

void add_brick_wall(MeshBuilder& builder, const GraveyardMaterials& m) {
  constexpr float kPitch = 0.40f, kCourse = 0.132f, kJoint = 0.014f, kHalf = 0.15f;
  constexpr int kCourses = 15, kAcross = int(kBrickWallLength / kPitch);
  builder.set_material(m.brick, 0.9f);
  for (int row = 0; row < kCourses; ++row) {
    for (int column = 0; column < kAcross; ++column) {
      const auto chance = [&](uint32_t seed) {
        return hash_unit(uint32_t(column), uint32_t(row), seed);
      };
      const float x0 =
          -0.5f * kBrickWallLength + kPitch * (float(column) + ((row & 1) != 0 ? 0.5f : 0.0f));

      // The upper courses have fallen, most in two places.
      const float gap = 3.2f * tiling_noise({x0 / kBrickWallLength + 0.5f, 0.5f}, 5, 3, 121);
      if (float(row) > float(kCourses) + 1.5f - 3.2f * gap) continue;
      const float y0 = kCourse * float(row) - 0.15f;
      const float out = 0.035f * chance(123) * chance(124) * 2.0f - 0.012f;
      add_bevelled_box(
          builder, {x0 + kJoint * (0.5f + chance(125)), y0, -kHalf - 0.03f * chance(126)},
          {x0 + kPitch - kJoint * chance(127), y0 + kCourse - kJoint, kHalf + out}, 0.012f);
    }
  }
  builder.set_material(m.mortar, 1.0f);
  add_box(builder, {-0.5f * kBrickWallLength + 0.03f, -0.4f, -kHalf + 0.025f},
          {0.5f * kBrickWallLength - 0.03f, kCourse * 5.0f, kHalf - 0.025f}, kCoarse);
}

void add_fence_panel(MeshBuilder& builder, const GraveyardMaterials& m) {
  constexpr int kRods = 10;
  constexpr float kPitch = kFencePanel / kRods;
  builder.set_material(m.iron);
  for (const float y : {0.22f, 1.02f, 1.17f})
    add_box(builder, {0, y, -0.02f}, {kFencePanel, y + 0.03f, 0.02f}, Tessellation{3.0f});
  for (int k = 0; k < kRods; ++k) {
    const float x = kPitch * (float(k) + 0.5f);
    builder.set_transform(moved({x, 0, 0}));
    add_lathe(builder, rod_profile(), 6);
    if (k + 1 == kRods) break;
    add_closed_tube(
        builder,
        [=](float t) {
          const float angle = 2 * kPi * t;
          return glm::vec3(0.5f * kPitch + 0.058f * std::cos(angle),
                           1.11f + 0.058f * std::sin(angle), 0);
        },
        0.009f, 12, 5);
  }
  builder.set_transform(glm::mat4(1.0f));
}

void add_fence_pillar(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.stone, 1.4f);
  add_bevelled_box(builder, {-0.26f, -0.3f, -0.26f}, {0.26f, 0.28f, 0.26f}, 0.03f);
  add_bevelled_box(builder, {-0.20f, 0.26f, -0.20f}, {0.20f, 1.50f, 0.20f}, 0.025f);
  add_bevelled_box(builder, {-0.27f, 1.48f, -0.27f}, {0.27f, 1.62f, 0.27f}, 0.04f);
  add_sphere(builder, {0, 1.80f, 0}, 0.19f, 20);
}

void add_lantern_post(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.iron);
  std::vector<glm::vec3> points{{0, -0.4f, 0}, {0, 0.5f, 0}, {0, 1.2f, 0}, {0, 1.62f, 0}};
  for (int k = 0; k <= 10; ++k) {
    const float angle = 1.12f * kPi * float(k) / 10.0f;
    points.emplace_back(0.17f * std::cos(angle) - 0.17f, 1.70f + 0.19f * std::sin(angle), 0);
  }
  add_tapered_tube(builder, points, std::vector<float>(points.size(), 0.017f), 8);
}

void add_lantern(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.iron);
  add_closed_tube(
      builder,
      [](float t) {
        const float angle = 2 * kPi * t;
        return glm::vec3(0, 0.045f * std::sin(angle) - 0.055f, 0.045f * std::cos(angle));
      },
      0.007f, 16, 6);
  Profile roof({0, -0.20f}, kCoarse);
  roof.line_to({0.15f, -0.20f})
      .line_to({0.15f, -0.185f})
      .arc_to({0.055f, -0.125f}, -0.5f, 3)
      .line_to({0.055f, -0.110f})
      .line_to({0, -0.095f});
  add_lathe(builder, roof, 12);
  Profile base({0, -0.50f}, kCoarse);
  base.line_to({0.11f, -0.50f})
      .line_to({0.13f, -0.485f})
      .line_to({0.13f, -0.465f})
      .line_to({0, -0.465f});
  add_lathe(builder, base, 12);
  for (int k = 0; k < 6; ++k) {
    const glm::vec2 c = 0.115f * unit_circle_point(k, 6);
    add_box(builder, {c.x - 0.006f, -0.47f, c.y - 0.006f}, {c.x + 0.006f, -0.195f, c.y + 0.006f},
            Tessellation{3.0f});
  }
  builder.set_transform(moved({0, -0.467f, 0}));
  add_candle(builder, m);
  builder.set_transform(glm::mat4(1.0f));
}

void add_candle(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.wax);
  Profile wax({0, 0}, kFine);
  wax.line_to({0.034f, 0})
      .line_to({0.032f, 0.105f})
      .arc_to({0.024f, 0.108f}, 2.0f, 3)
      .arc_to({0, 0.098f}, -0.6f, 2);
  add_lathe(builder, wax, 14);
  builder.set_material(m.flame);
  Profile flame({0, 0.108f}, kFine);
  flame.arc_to({0.012f, 0.130f}, 1.3f, 4).arc_to({0, 0.180f}, 0.6f, 4);
  add_lathe(builder, flame, 10);
}

void add_raven(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.feathers, 0.3f);
  const auto raven = [](glm::vec3 p) {
    const auto wing_p = glm::vec3(std::abs(p.x), p.y, p.z);
    float d = sdf::ellipsoid(p, {0, 0.145f, 0}, {0.062f, 0.075f, 0.11f});
    d = sdf::smooth_min(d, sdf::cone(p, {0, 0.17f, 0.06f}, {0, 0.235f, 0.095f}, 0.05f, 0.043f),
                        0.04f);
    d = sdf::smooth_min(d, sdf::cone(p, {0, 0.235f, 0.12f}, {0, 0.222f, 0.20f}, 0.022f, 0.008f),
                        0.012f);
    d = sdf::smooth_min(d, sdf::ellipsoid(wing_p, {0.052f, 0.15f, -0.05f}, {0.022f, 0.05f, 0.13f}),
                        0.02f);
    d = sdf::smooth_min(d, sdf::cone(p, {0, 0.13f, -0.08f}, {0, 0.075f, -0.24f}, 0.03f, 0.022f),
                        0.03f);
    return std::min(d, sdf::capsule(wing_p, {0.025f, 0.09f, 0.01f}, {0.028f, 0.0f, 0.02f}, 0.012f));
  };
  add_isosurface_of(builder, {raven, 2.0f, {-0.12f, -0.03f, -0.3f}, {0.12f, 0.31f, 0.24f}}, 3'200);
}

}  // namespace lueur::builtin
