// SPDX-License-Identifier: MIT
// Tombstones: plates of several outlines on a plinth, crosses, an obelisk and a chest.
#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin/graveyard_parts.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

const Tessellation kFine{0.12f};
constexpr float kSunk = 0.35f;  // m that each reaches into the ground

glm::mat4 moved(glm::vec3 by) {
  return glm::translate(glm::mat4(1.0f), by);
}

void add_plinth(MeshBuilder& builder, glm::vec2 half, float top) {
  add_bevelled_box(builder, {-half.x, -kSunk, -half.y}, {half.x, top, half.y}, 0.025f);
}

// A plate that stands on the plinth at height `y`.
void add_standing(MeshBuilder& builder, const Profile& outline, glm::vec2 center, float y,
                  float thickness, float bevel) {
  builder.set_transform(moved({0, y, 0}));
  add_plate(builder, outline, center, thickness, bevel);
  builder.set_transform(glm::mat4(1.0f));
}

// A raised panel of `size` with lines of writing on it, on a face at z.
void add_panel(MeshBuilder& builder, const GraveyardMaterials& m, glm::vec2 center, glm::vec2 size,
               float z) {
  builder.set_material(m.slab, 1.0f);
  const glm::vec2 low = center - 0.5f * size;
  const auto uv = [=](glm::vec3 p, glm::vec3) {
    const glm::vec2 across = (glm::vec2(p) - low) / size;
    return glm::vec2(across.x, 1.0f - across.y);
  };
  add_bevelled_box(builder, {low, z - 0.02f}, {low + size, z + 0.02f}, 0.012f, uv);
}

Profile slab_outline(Tombstone kind) {
  constexpr float kHalf = 0.40f;
  Profile outline({-kHalf, 0}, kFine);
  outline.line_to({kHalf, 0});
  switch (kind) {
    case Tombstone::pointed:
      outline.line_to({kHalf, 0.78f})
          .arc_to({0, 1.30f}, 0.75f, 6)
          .arc_to({-kHalf, 0.78f}, 0.75f, 6);
      break;
    case Tombstone::shouldered:
      outline.line_to({kHalf, 0.80f})
          .arc_to({0.72f * kHalf, 0.92f}, 1.5f, 3)
          .arc_to({0.55f * kHalf, 0.98f}, -1.4f, 3)
          .arc_to({-0.55f * kHalf, 0.98f}, 2.3f, 10)
          .arc_to({-0.72f * kHalf, 0.92f}, -1.4f, 3)
          .arc_to({-kHalf, 0.80f}, 1.5f, 3);
      break;
    case Tombstone::broken:
      outline.line_to({kHalf, 0.58f})
          .line_to({0.62f * kHalf, 0.66f})
          .line_to({0.30f * kHalf, 0.61f})
          .line_to({-0.12f * kHalf, 0.83f})
          .line_to({-0.55f * kHalf, 0.88f})
          .line_to({-kHalf, 1.02f});
      break;
    default:
      outline.line_to({kHalf, 0.72f}).arc_to({-kHalf, 0.72f}, kPi, 16);
  }
  outline.line_to({-kHalf, 0});
  return outline;
}

// A cross from the plinth up: `arm` is half an arm's width, `reach` from the middle outwards.
Profile cross_outline(float arm, float reach, float middle, float top) {
  const float flare = 1.35f * arm;  // arms widen to their ends
  Profile outline({-flare, 0}, Tessellation{1.0f});
  outline.line_to({flare, 0})
      .line_to({arm, middle - arm})
      .line_to({reach, middle - flare})
      .line_to({reach, middle + flare})
      .line_to({arm, middle + arm})
      .line_to({flare, top})
      .line_to({-flare, top})
      .line_to({-arm, middle + arm})
      .line_to({-reach, middle + flare})
      .line_to({-reach, middle - flare})
      .line_to({-arm, middle - arm})
      .line_to({-flare, 0});
  return outline;
}

void add_cross(MeshBuilder& builder, const GraveyardMaterials& m, bool ringed) {
  builder.set_material(m.stone, 1.4f);
  add_plinth(builder, {0.42f, 0.30f}, 0.14f);
  builder.set_transform(moved({0, 0, 0}));
  add_bevelled_box(builder, {-0.29f, 0.12f, -0.20f}, {0.29f, 0.34f, 0.20f}, 0.03f);
  const float middle = 1.12f;
  add_standing(builder, cross_outline(0.095f, 0.42f, middle, 1.60f), {0, middle}, 0.32f, 0.20f,
               0.03f);
  if (!ringed) return;

  // The wheel around the crossing, and a boss on it.
  const glm::vec3 center{0, 0.32f + middle, 0};
  add_closed_tube(
      builder,
      [=](float t) {
        const float angle = 2 * kPi * t;
        return center + 0.31f * glm::vec3(std::cos(angle), std::sin(angle), 0);
      },
      0.052f, 40, 10);
  add_sphere(builder, center + glm::vec3(0, 0, 0.07f), 0.085f, 16);
}

void add_obelisk(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.granite, 1.5f);
  add_plinth(builder, {0.52f, 0.52f}, 0.16f);
  add_bevelled_box(builder, {-0.40f, 0.14f, -0.40f}, {0.40f, 0.66f, 0.40f}, 0.03f);
  add_bevelled_box(builder, {-0.45f, 0.64f, -0.45f}, {0.45f, 0.76f, 0.45f}, 0.04f);
  const auto tapered = [&](float y0, float y1, float half0, float half1) {
    std::array<glm::vec3, 8> corners;
    for (int k = 0; k < 8; ++k) {
      const float half = (k & 2) != 0 ? half1 : half0;
      corners[k] = {(k & 1) != 0 ? half : -half, (k & 2) != 0 ? y1 : y0,
                    (k & 4) != 0 ? half : -half};
    }
    add_hexahedron(builder, corners, Tessellation{0.5f});
  };
  tapered(0.75f, 2.35f, 0.27f, 0.18f);
  tapered(2.35f, 2.60f, 0.18f, 0.01f);
  add_panel(builder, m, {0, 0.40f}, {0.56f, 0.36f}, 0.40f);
}

void add_chest(MeshBuilder& builder, const GraveyardMaterials& m) {
  builder.set_material(m.stone, 1.4f);
  builder.set_transform(glm::mat4(1.0f));
  add_plinth(builder, {0.62f, 1.10f}, 0.12f);
  add_bevelled_box(builder, {-0.46f, 0.10f, -0.94f}, {0.46f, 0.62f, 0.94f}, 0.02f);
  for (const float x : {-0.46f, 0.46f})
    for (const float z : {-0.88f, 0.0f, 0.88f})
      add_bevelled_box(builder, {x - 0.07f, 0.1f, z - 0.08f}, {x + 0.07f, 0.63f, z + 0.08f},
                       0.025f);
  add_bevelled_box(builder, {-0.60f, 0.61f, -1.08f}, {0.60f, 0.74f, 1.08f}, 0.04f);

  // A cross lies on the lid.
  const glm::mat4 lay{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0.75f, 0.80f, 1}};
  builder.set_transform(lay);
  add_plate(builder, cross_outline(0.06f, 0.30f, 1.05f, 1.50f), {0, 1.05f}, 0.08f, 0.02f);
  builder.set_transform(glm::mat4(1.0f));
}

}  // namespace

void add_tombstone(MeshBuilder& builder, const GraveyardMaterials& m, Tombstone kind) {
  if (kind == Tombstone::cross || kind == Tombstone::ringed_cross)
    return add_cross(builder, m, kind == Tombstone::ringed_cross);
  if (kind == Tombstone::obelisk) return add_obelisk(builder, m);
  if (kind == Tombstone::chest) return add_chest(builder, m);
  const bool granite = kind == Tombstone::pointed;
  builder.set_material(granite ? m.granite : m.stone, 1.4f);
  add_plinth(builder, {0.50f, 0.22f}, 0.13f);
  const float thickness = kind == Tombstone::broken ? 0.14f : 0.18f;
  add_standing(builder, slab_outline(kind), {0, 0.45f}, 0.12f, thickness, 0.03f);
  if (kind != Tombstone::broken)
    add_panel(builder, m, {0, 0.56f}, {0.56f, 0.50f}, 0.5f * thickness);
}

}  // namespace lueur::builtin
