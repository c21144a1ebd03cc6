// SPDX-License-Identifier: MIT
// After figure 9 of "Hierarchical Screen-Space Indirect Illumination for Video Games" (Soler, Hoel,
// Rochet, Holzschuch 2009): a lamp behind a basket lights the side that the camera does not see,
// and what comes off it lights the wall. A second lamp puts a patch of light on the floor in full
// view.
#include "scene/builtin/basket.h"

#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/room_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"

namespace lueur::builtin {
namespace {

constexpr glm::vec3 kBasket{0.15f, 0, -0.45f};
constexpr float kScale = 1.2f;  // a large one,
constexpr float kWide = 1.65f;  // and oval: wide enough to hide its back
constexpr glm::vec3 kLitPlace = kBasket + kScale * glm::vec3(0, 0.44f, -kBasketRadius);
constexpr float kBackWall = -1.86f;

void add_room_of_plants(Scene& scene) {
  const int32_t plaster = add_patterned_material(scene, "plaster", {0.92f, 0.88f, 0.80f}, 0.95f,
                                                 256, 2.0f, plaster_pattern());
  const int32_t wood = add_patterned_material(scene, "wood", glm::vec3(1.0f), 0.6f, 256, 1.0f,
                                              board_pattern(kOakDark, kOakLight));
  Room room{.min = {-3.0f, 0, kBackWall}, .max = {3.0f, 3.2f, 3.6f}};
  room.left = room.right = room.back = room.front = room.ceiling = plaster;
  room.floor =
      add_patterned_material(scene, "tiles", {1.0f, 0.90f, 0.78f}, 0.6f, 512, 1.6f, tile_pattern());
  room.floor_texture_m = 1.6f;
  add_room(scene, room, Tessellation{0.5f});
  add_skirting(scene, room, {.material = plaster, .height_m = 0.10f});

  // A shelf on the wall, for pots.
  MeshBuilder shelf;
  shelf.set_material(wood, 1.0f);
  const Tessellation fine{0.25f};
  add_rounded_box(shelf, {1.15f, 1.22f, kBackWall - 0.01f}, {2.75f, 1.26f, kBackWall + 0.27f},
                  0.008f, fine);
  for (const float x : {1.35f, 2.50f})
    add_rounded_box(shelf, {x, 1.00f, kBackWall - 0.01f}, {x + 0.05f, 1.225f, kBackWall + 0.17f},
                    0.008f, fine);
  add_mesh(scene, shelf.finish("shelf"));
}

void add_basket(Scene& scene, int32_t soil) {
  // Stained a deep orange: what it throws back is easy to tell from all else.
  const int32_t wicker = add_patterned_material(scene, "wicker", {1.0f, 0.55f, 0.20f}, 0.7f, 256,
                                                0.5f, cloth_pattern());
  const int32_t leaves = add_material(scene, "leaves", {0.13f, 0.34f, 0.07f}, 0.6f);
  const int32_t petals = add_material(scene, "petals", {0.90f, 0.88f, 0.80f}, 0.8f);
  MeshBuilder basket;
  add_wicker(basket, wicker, soil);
  const int32_t node = add_mesh(scene, basket.finish("basket"));
  scene.nodes[node].translation = kBasket;
  scene.nodes[node].scale = glm::vec3(kWide, kScale, kScale);

  MeshBuilder plant;
  plant.set_material(leaves, 0.3f);
  add_foliage(plant, {.count = 44,
                      .height_m = kBasketHeight - 0.07f,
                      .length_m = 0.52f,
                      .width_m = 0.125f,
                      .rise = 1.35f,
                      .seed = 5});
  plant.set_material(petals, 0.3f);
  for (int k = 0; k < 15; ++k) {
    const float angle = 2.399963f * float(k) + 0.3f, out = 0.08f + 0.26f * std::sqrt(float(k) / 15);
    add_blossom(plant,
                {out * std::cos(angle), kBasketHeight + 0.44f - 0.55f * out * out / 0.34f,
                 out * std::sin(angle)},
                0.045f);
  }
  scene.meshes.push_back(plant.finish("plant"));
  for (const float side : {-1.0f, 1.0f}) {
    const int32_t grown = add_node(scene, "plant", kBasket + glm::vec3(0.34f * side, 0, 0),
                                   glm::angleAxis(1.1f * side, glm::vec3(0, 1, 0)));
    scene.nodes[grown].scale = glm::vec3(kScale);
    add_instance(scene, int32_t(scene.meshes.size()) - 1, grown);
  }
}

void add_pots(Scene& scene, int32_t soil) {
  const int32_t clay = add_patterned_material(scene, "terracotta", {0.78f, 0.36f, 0.20f}, 0.85f,
                                              256, 0.6f, plaster_pattern());
  const int32_t succulent = add_material(scene, "succulent", {0.20f, 0.38f, 0.24f}, 0.6f);
  struct Pot {
    const char* name;
    glm::vec3 place;
    float height;
    int leaves;
  };
  for (const Pot& pot : {Pot{"large pot", {1.95f, 0, -1.25f}, 0.52f, 30},
                         Pot{"small pot", {1.55f, 0, -0.65f}, 0.26f, 0},
                         Pot{"shelf pot", {1.62f, 1.26f, kBackWall + 0.14f}, 0.20f, 18},
                         Pot{"other shelf pot", {2.20f, 1.26f, kBackWall + 0.13f}, 0.16f, 14}}) {
    MeshBuilder builder;
    add_clay_pot(builder, clay, soil, pot.height);
    if (pot.leaves > 0) {
      builder.set_material(succulent, 0.3f);
      add_foliage(builder, {.count = pot.leaves,
                            .height_m = 0.88f * pot.height,
                            .length_m = 0.95f * pot.height,
                            .width_m = 0.22f * pot.height,
                            .rise = 1.3f,
                            .seed = uint32_t(pot.leaves)});
    }
    const int32_t node = add_mesh(scene, builder.finish(pot.name));
    scene.nodes[node].translation = pot.place;
  }
}

// The lamp behind is the brighter one: what is in the shade of both is mostly its.
void add_lamps(Scene& scene) {
  const int32_t metal = add_material(scene, "black metal", glm::vec3(0.05f), 0.45f);
  const glm::vec3 warm{1.0f, 0.92f, 0.80f};
  constexpr float kLux = 1500.0f;
  const auto lamp = [&](const char* name, glm::vec3 from, glm::vec3 to, float radius_m, float lux) {
    const float distance = glm::distance(from, to), cone = std::atan(radius_m / distance);
    return add_spot_lamp(scene, {.name = name,
                                 .from = from,
                                 .to = to,
                                 .color = warm,
                                 .intensity_cd = lux * distance * distance,
                                 .outer_cone_rad = cone,
                                 .inner_cone_rad = 0.8f * cone,
                                 .case_material = metal});
  };

  // The one behind keeps within the basket's outline, also as it wanders.
  const glm::vec3 behind = kLitPlace + glm::vec3(0, -0.03f, -0.72f);
  const int32_t hidden = lamp("lamp behind", behind, kLitPlace, 0.37f, kLux);
  animate_rotation(scene, hidden, 40, [=](float phase) {
    return look_along(kLitPlace + glm::vec3(0.05f * std::sin(2 * kPi * phase), 0, 0) - behind);
  });
  lamp("lamp above", {-2.7f, 3.0f, 1.4f}, {-1.75f, 0.0f, -0.10f}, 0.95f, 0.8f * kLux);
  scene.exposure_ev = 1.1f + exposure_for(0.75f, kLux);
}

}  // namespace

Scene make_basket() {
  Scene scene;
  scene.name = "basket";
  const glm::vec3 target{-0.28f, 0.84f, -0.9f};
  const auto eye = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(0.25f * std::sin(angle), 1.50f + 0.10f * std::sin(2 * angle), 3.35f);
  };
  const int32_t camera = add_camera(scene, "front", eye(0), target, 0.82f);
  animate_camera(scene, camera, 40, eye, [=](float) { return target; });
  add_camera(scene, "side", {-0.85f, 1.2f, -1.74f}, {0.24f, 0.60f, -0.98f}, 1.05f);
  add_room_of_plants(scene);
  const int32_t soil = add_material(scene, "soil", {0.07f, 0.045f, 0.03f}, 1.0f);
  add_basket(scene, soil);
  add_pots(scene, soil);

  add_lamps(scene);
  return scene;
}

}  // namespace lueur::builtin
