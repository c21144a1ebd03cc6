// SPDX-License-Identifier: MIT
// After the test scene of "Indirect Diffuse and Glossy Illumination on the GPU" (Szirmay-Kalos,
// Lazányi 2006): a cubic room of coloured sides with a divider in it, and one detailed object that
// takes up the colours of what it comes near: along a wall, into a corner, around the divider.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/detailed_object.h"
#include "scene/builtin/room_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"

namespace lueur::builtin {
namespace {

constexpr uint32_t kTriangles = 60'000;
constexpr float kHalf = 3.0f;  // m: half the room's side
constexpr float kDividerX = 0.55f;
constexpr float kDividerEnd = -0.5f;  // z; it begins at the back wall
constexpr float kDividerHeight = 3.3f;

// The object's way over the floor (x, z), there and back within a loop: the middle, the yellow
// wall, the corner behind it, along the divider and around its end, behind it.
constexpr std::array<glm::vec2, 9> kWay = {{{-1.0f, -0.6f},
                                            {-1.95f, -0.2f},
                                            {-2.05f, -1.2f},
                                            {-1.90f, -1.95f},
                                            {-0.85f, -1.6f},
                                            {-0.60f, -0.1f},
                                            {0.75f, 0.50f},
                                            {1.80f, 0.0f},
                                            {1.80f, -1.85f}}};

glm::vec3 place_at(float phase) {
  const float at = (0.5f - 0.5f * std::cos(2 * kPi * phase)) * float(kWay.size() - 1);
  const int k = std::min(int(at), int(kWay.size()) - 2);
  const auto way = [](int n) { return kWay[size_t(std::clamp(n, 0, int(kWay.size()) - 1))]; };
  const glm::vec2 a = way(k - 1), b = way(k), c = way(k + 1), d = way(k + 2);
  const float t = at - float(k);

  // Catmull and Rom's curve through the places.
  const glm::vec2 p =
      b + 0.5f * t *
              ((c - a) + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
  return {p.x, 0, p.y};
}

int32_t add_sides(Scene& scene) {
  const int32_t white = add_patterned_material(scene, "plaster", {0.90f, 0.87f, 0.82f}, 0.95f, 256,
                                               2.0f, plaster_pattern());
  Room room{.min = {-kHalf, 0, -kHalf}, .max = {kHalf, 2 * kHalf, kHalf}};
  room.left = add_tinted_material(scene, "yellow plaster", white, {0.88f, 0.56f, 0.06f});
  room.right = add_tinted_material(scene, "blue plaster", white, {0.09f, 0.21f, 0.66f});
  room.ceiling = add_tinted_material(scene, "green plaster", white, {0.30f, 0.58f, 0.26f});
  room.back = room.front = white;
  room.floor = add_patterned_material(scene, "oak boards", glm::vec3(1.0f), 0.6f, 512, 1.4f,
                                      board_pattern(kOakDark, kOakLight));
  room.floor_texture_m = 1.4f;
  add_room(scene, room, Tessellation{0.5f});
  add_skirting(scene, room, {.material = white, .height_m = 0.18f});
  return white;
}

void add_divider(Scene& scene, int32_t white) {
  const int32_t red = add_tinted_material(scene, "red plaster", white, {0.80f, 0.09f, 0.06f});
  const Tessellation tessellation{0.25f};
  const glm::vec3 low(kDividerX - 0.09f, -0.05f, -kHalf - 0.05f);
  const glm::vec3 high(kDividerX + 0.09f, kDividerHeight, kDividerEnd);
  MeshBuilder wall;
  wall.set_material(red, 2.0f);
  add_rounded_box(wall, low, high, 0.02f, tessellation);
  add_mesh(scene, wall.finish("divider"));

  // A coping on top, a plinth at the foot.
  MeshBuilder trim;
  trim.set_material(white, 2.0f);
  add_rounded_box(trim, {low.x - 0.04f, high.y - 0.03f, low.z},
                  {high.x + 0.04f, high.y + 0.06f, high.z + 0.04f}, 0.025f, tessellation);
  add_rounded_box(trim, {low.x - 0.025f, low.y, low.z}, {high.x + 0.025f, 0.16f, high.z + 0.025f},
                  0.018f, tessellation);
  add_mesh(scene, trim.finish("divider trim"));
}

void add_lamps(Scene& scene) {
  const int32_t metal = add_material(scene, "black metal", glm::vec3(0.05f), 0.45f);
  const glm::vec3 warm{1.0f, 0.90f, 0.76f};
  add_spot_lamp(scene, {.name = "left lamp",
                        .from = {-0.9f, 5.75f, 1.5f},
                        .to = {-2.75f, 1.3f, -1.0f},
                        .color = warm,
                        .intensity_cd = 30'000.0f,
                        .outer_cone_rad = 0.42f,
                        .inner_cone_rad = 0.24f,
                        .case_material = metal});
  add_spot_lamp(scene, {.name = "right lamp",
                        .from = {2.0f, 5.75f, 0.6f},
                        .to = {2.2f, 0.9f, -2.4f},
                        .color = warm,
                        .intensity_cd = 30'000.0f,
                        .outer_cone_rad = 0.38f,
                        .inner_cone_rad = 0.22f,
                        .case_material = metal});
  const Light& light = scene.lights.front();
  const float distance = 5.4f;
  scene.exposure_ev = 0.5f + exposure_for(0.75f, light.intensity / (distance * distance));
}

}  // namespace

Scene make_divider_room() {
  Scene scene;
  scene.name = "divider-room";
  const glm::vec3 target{0.05f, 1.30f, -1.3f};
  const auto eye = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(-0.45f + 0.35f * std::sin(angle), 2.2f + 0.12f * std::sin(2 * angle), 2.8f);
  };
  const int32_t camera = add_camera(scene, "room", eye(0), target, 1.0f);
  animate_camera(scene, camera, 40, eye, [=](float) { return target; });
  add_camera(scene, "left", {-0.2f, 1.9f, 1.0f}, {-2.0f, 0.8f, -1.4f}, 0.95f);
  add_camera(scene, "behind", {2.55f, 2.3f, 1.6f}, {1.3f, 0.8f, -1.9f}, 0.95f);
  add_divider(scene, add_sides(scene));

  const int32_t node = add_node(scene, "way", place_at(0));
  add_detailed_object(scene, {.triangles = kTriangles, .height_m = 1.75f}, node);
  animate_translation(scene, node, 80, place_at);
  animate_rotation(scene, node, 40, [](float phase) {
    return glm::angleAxis(0.25f - 0.75f * std::sin(2 * kPi * phase), glm::vec3(0, 1, 0));
  });
  add_lamps(scene);
  return scene;
}

}  // namespace lueur::builtin
