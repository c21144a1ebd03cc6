// SPDX-License-Identifier: MIT
// After the test scene of "Second-Order Illumination in Real-Time" (Cochran, Steele 2007): one
// detailed object floats in a box, lit by a spotlight.
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/detailed_object.h"
#include "scene/builtin/room_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"

namespace lueur::builtin {
namespace {

constexpr uint32_t kTriangles = 69'000;
constexpr glm::vec3 kFloat{0.0f, 1.25f, -0.35f};  // where the object's foot hovers

Room add_box_room(Scene& scene) {
  const int32_t white = add_patterned_material(scene, "plaster", {0.92f, 0.89f, 0.84f}, 0.95f, 256,
                                               2.0f, plaster_pattern());
  Room room{.min = {-2.6f, 0, -2.4f}, .max = {2.6f, 4.2f, 5.2f}};
  room.left = add_tinted_material(scene, "coral plaster", white, {0.86f, 0.20f, 0.11f});
  room.right = add_tinted_material(scene, "teal plaster", white, {0.04f, 0.38f, 0.44f});
  room.back = room.ceiling = room.front = white;
  room.floor =
      add_patterned_material(scene, "tiles", glm::vec3(1.0f), 0.6f, 512, 2.0f, tile_pattern());
  add_room(scene, room, Tessellation{1.0f});
  add_skirting(scene, room, {.material = white});
  return room;
}

}  // namespace

Scene make_floating_object() {
  Scene scene;
  scene.name = "floating-object";
  const glm::vec3 target{0, 1.75f, -0.6f};
  const auto eye = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(0.55f * std::sin(angle), 1.95f + 0.18f * std::cos(angle), 4.35f);
  };
  const int32_t camera = add_camera(scene, "front", eye(0), target, 0.80f);
  animate_camera(scene, camera, 40, eye, [=](float) { return target; });
  add_camera(scene, "close", {-1.45f, 2.35f, 1.75f}, {0.05f, 1.88f, -0.3f}, 0.75f);
  add_box_room(scene);

  // The object turns once and rises and sinks a little.
  const int32_t node = add_node(scene, "float", kFloat);
  add_detailed_object(scene, {.triangles = kTriangles, .height_m = 1.45f}, node);
  animate_rotation(scene, node, 40,
                   [](float phase) { return glm::angleAxis(2 * kPi * phase, glm::vec3(0, 1, 0)); });
  animate_translation(scene, node, 40, [](float phase) {
    return kFloat + glm::vec3(0, 0.08f * std::sin(4 * kPi * phase), 0);
  });

  Light spot;
  spot.name = "spot";
  spot.kind = LightKind::spot;
  const glm::vec3 from{1.7f, 4.0f, 2.6f}, to{-0.35f, 1.3f, -0.9f};
  spot.node = add_node(scene, "spot", from, look_along(to - from));
  spot.color = {1.0f, 0.93f, 0.82f};
  spot.intensity = 30'000.0f;
  spot.outer_cone_rad = 0.62f;
  spot.inner_cone_rad = 0.45f;
  scene.lights.push_back(spot);
  const float distance = glm::distance(from, kFloat);
  scene.exposure_ev = exposure_for(0.85f, spot.intensity / (distance * distance));
  return scene;
}

}  // namespace lueur::builtin
