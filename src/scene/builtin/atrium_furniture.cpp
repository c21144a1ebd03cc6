// SPDX-License-Identifier: MIT
// Columns, planters, the fountain and the drapes of the atrium.
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

// A round column `height` tall with a shaft of `radius` at its foot: square plinth, two rolls, a
// shaft that swells a little and narrows upwards (entasis), a capital and a square abacus.
void add_any_column(MeshBuilder& builder, float radius, float height,
                    const Tessellation& tessellation) {
  const float r = radius, top_r = 0.85f * radius, half = 1.4f * radius;
  const float plinth = 0.6f * r, abacus = 0.7f * r;
  const float shaft0 = plinth + 0.95f * r, shaft1 = height - abacus - 1.6f * r;
  add_box(builder, {-half, -0.01f, -half}, {half, plinth, half}, tessellation, kNegativeY);
  Profile profile({0, plinth - 0.02f}, tessellation);
  profile.line_to({1.3f * r, plinth - 0.02f})
      .arc_to({1.22f * r, plinth + 0.45f * r}, 2.6f)
      .arc_to({r, shaft0}, -1.6f)
      .arc_to({top_r, shaft1}, 0.07f, 2)
      .arc_to({top_r, shaft1 + 0.3f * r}, 2.6f)
      .arc_to({1.3f * r, height - abacus - 0.3f * r}, -1.2f)
      .arc_to({1.3f * r, height - abacus + 0.02f}, 1.6f, 1)
      .line_to({0, height - abacus + 0.02f});
  add_lathe(builder, profile, tessellation.curved(2 * kPi * radius, 6));
  add_box(builder, {-half, height - abacus, -half}, {half, height + 0.01f, half}, tessellation,
          kPositiveY);
}

// A round rod along x from -half_length to half_length at height y.
void add_rod(MeshBuilder& builder, float half_length, float y, float radius,
             const Tessellation& tessellation) {
  // The lathe's y becomes x.
  const glm::mat4 lay{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}, {0, y, 0, 1}};
  builder.set_transform(lay);
  Profile profile({0, -half_length}, tessellation);
  profile.line_to({radius, -half_length}).line_to({radius, half_length}).line_to({0, half_length});
  add_lathe(builder, profile, tessellation.curved(2 * kPi * radius, 5));
  builder.set_transform(glm::mat4(1.0f));
}

}  // namespace

void add_column(MeshBuilder& builder, const AtriumMaterials& materials,
                const Tessellation& tessellation) {
  builder.set_material(materials.limestone, 2.0f);
  add_any_column(builder, 0.25f, kColumnHeight, tessellation);
}

void add_upper_column(MeshBuilder& builder, const AtriumMaterials& materials,
                      const Tessellation& tessellation) {
  builder.set_material(materials.limestone, 2.0f);
  add_any_column(builder, 0.2f, kUpperColumnHeight, tessellation);
}

void add_planter(MeshBuilder& builder, const AtriumMaterials& materials,
                 const Tessellation& tessellation) {
  builder.set_material(materials.terracotta, 1.0f);
  Profile pot({0, -0.01f}, tessellation);
  pot.line_to({0.24f, -0.01f})
      .line_to({0.24f, 0.06f})
      .arc_to({0.15f, 0.14f}, -1.0f, 1)
      .arc_to({0.38f, 0.60f}, 0.8f, 3)
      .arc_to({0.44f, 0.70f}, -0.9f, 1)
      .line_to({0.44f, 0.76f})
      .line_to({0.37f, 0.76f})
      .line_to({0.35f, 0.66f})
      .line_to({0, 0.66f});
  add_lathe(builder, pot, tessellation.curved(2 * kPi * 0.4f, 5));

  // A clipped bush: a ball with leaves in clumps.
  builder.set_material(materials.leaves, 0.5f);
  add_sphere(builder, {0, 1.12f, 0}, 0.5f, tessellation.curved(2 * kPi * 0.5f, 6), [](glm::vec3 d) {
    const float angle = std::atan2(d.z, d.x) / (2 * kPi) + 0.5f;
    const float wobble =
        std::sin(9.0f * d.x) * std::sin(11.0f * d.y + 1.0f) * std::sin(10.0f * d.z + 2.0f);
    const float ring = 1.0f - d.y * d.y;  // fades the pattern out at the poles
    return 1.0f + 0.06f * wobble + 0.03f * ring * std::sin(2 * kPi * 9.0f * angle + 7.0f * d.y);
  });
}

void add_fountain(MeshBuilder& builder, const AtriumMaterials& materials,
                  const Tessellation& tessellation) {
  builder.set_material(materials.limestone, 2.0f);
  Profile basin({0, -0.02f}, tessellation);
  basin.line_to({1.45f, -0.02f})
      .line_to({1.45f, 0.10f})
      .arc_to({1.30f, 0.20f}, -1.2f)
      .line_to({1.30f, 0.46f})
      .arc_to({1.42f, 0.52f}, -0.8f, 1)
      .arc_to({1.42f, 0.62f}, 2.4f)
      .line_to({1.18f, 0.62f})
      .line_to({1.18f, 0.15f})
      .line_to({0, 0.15f});
  add_lathe(builder, basin, tessellation.curved(2 * kPi * 1.4f, 8));
  Profile stem({0, 0.1f}, tessellation);
  stem.line_to({0.30f, 0.1f})
      .line_to({0.30f, 0.30f})
      .arc_to({0.13f, 0.60f}, -1.0f)
      .arc_to({0.13f, 0.95f}, 1.2f)
      .arc_to({0.62f, 1.28f}, 1.0f)
      .arc_to({0.62f, 1.34f}, 2.6f)
      .arc_to({0.10f, 1.14f}, -0.7f)
      .arc_to({0.07f, 1.40f}, -0.6f)
      .arc_to({0, 1.62f}, 3.4f, 4);
  add_lathe(builder, stem, tessellation.curved(2 * kPi * 0.5f, 6));
  builder.set_material(materials.water, 1.0f);
  Profile water({0, 0.3f}, tessellation);
  water.line_to({1.2f, 0.3f}).line_to({1.2f, 0.5f}).line_to({0, 0.5f});
  add_lathe(builder, water, tessellation.curved(2 * kPi * 1.2f, 8));
}

void add_curtains(MeshBuilder& builder, const AtriumMaterials& materials, int color,
                  const Tessellation& tessellation) {
  const float rod_y = kColumnHeight - 0.12f, top = rod_y - 0.02f, drop = 2.55f;
  const float reach = 1.17f;  // from the middle to the columns
  builder.set_material(materials.bronze);
  add_rod(builder, 1.3f, rod_y, 0.025f, tessellation);

  for (const bool left : {true, false}) {
    builder.set_material(materials.cloth[color], 0.5f);

    // The sheet narrows to the tie below its middle and opens again towards the floor.
    const auto middle = [=](float u, float v) {
      const float to_tie = glm::smoothstep(0.05f, 0.58f, v);
      const float from_tie = glm::smoothstep(0.58f, 1.0f, v);
      const float width = 1.05f - 0.77f * to_tie + 0.22f * from_tie;
      const float across = left ? u : 1.0f - u;  // 0 at the column
      const float phase = left ? 0.0f : 1.7f;
      const float fold =
          std::sin(2 * kPi * (3.5f * across + 0.06f * std::sin(5 * v + phase)) + phase) +
          0.2f * std::sin(2 * kPi * 5.5f * across + 3.0f * v + phase);
      const float depth = 0.055f - 0.020f * to_tie + 0.015f * from_tie;
      const float x = reach - width * across;
      const float sag = 0.30f * across * across * to_tie * (1.0f - 0.8f * from_tie);
      return glm::vec3(left ? -x : x, top - drop * v + sag * 0.4f, depth * fold);
    };
    const int across = tessellation.curved(3.0f, 6), down = tessellation.curved(drop, 2);
    add_cloth(builder, middle, {1.6f, drop}, 0.012f, across, down);

    // The tie: a ring around the gathered folds.
    if (!tessellation.shows(0.1f)) continue;
    builder.set_material(materials.bronze);
    const float x = (left ? -1.0f : 1.0f) * (reach - 0.14f);
    builder.set_transform(glm::translate(glm::mat4(1.0f), {x, top - drop * 0.58f + 0.02f, 0}));
    Profile ring({0, -0.03f}, tessellation);
    ring.line_to({0.15f, -0.03f}).line_to({0.15f, 0.03f}).line_to({0, 0.03f});
    add_lathe(builder, ring, tessellation.curved(2 * kPi * 0.15f, 5));
    builder.set_transform(glm::mat4(1.0f));
  }
}

void add_banner(MeshBuilder& builder, const AtriumMaterials& materials, int color,
                const Tessellation& tessellation) {
  const float width = 1.5f, drop = 2.7f;
  builder.set_material(materials.bronze);
  add_rod(builder, 0.9f, 0.0f, 0.025f, tessellation);
  builder.set_material(materials.cloth[color], 0.5f);
  const auto middle = [=](float u, float v) {
    // Waves grow from the rod down; the lower hem runs to a rounded point.
    const float wave = std::sin(2 * kPi * (2.5f * u + 0.1f * std::sin(3 * v))) +
                       0.4f * std::sin(2 * kPi * 4.5f * u + 2.0f);
    const float hem = 0.86f + 0.07f * (1.0f - std::cos(2 * kPi * u));
    const float depth = 0.012f + 0.05f * glm::smoothstep(0.0f, 1.0f, v);
    return glm::vec3((u - 0.5f) * width * (1.0f - 0.06f * v), -0.02f - drop * v * hem,
                     0.03f + depth * wave);
  };
  add_cloth(builder, middle, {width, drop}, 0.012f, tessellation.curved(width, 6),
            tessellation.curved(drop, 2));
}

}  // namespace lueur::builtin
