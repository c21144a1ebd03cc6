// SPDX-License-Identifier: MIT
// A table in a room that the low sun reaches through one window: it meets nothing but the wall
// across from it, and the patch there lights the room. Below the table lies the soft shadow of
// that light.
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "scene/builtin/room_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

constexpr float kSunLux = 30'000.0f;
constexpr glm::vec3 kSunDirection{-1.0f, -0.06f, -0.12f};
constexpr float kTableHeight = 0.75f;
constexpr glm::vec3 kTable{-0.55f, 0, -0.55f};
constexpr float kRight = 2.6f;  // x of the wall with the window
const Box kWindow{{kRight - 1, 1.38f, -1.15f}, {kRight + 1, 2.62f, 1.55f}};

void add_walls(Scene& scene) {
  const int32_t white = add_patterned_material(scene, "plaster", {0.96f, 0.93f, 0.87f}, 0.95f, 256,
                                               2.0f, plaster_pattern());
  Room room{.min = {-2.3f, 0, -2.1f}, .max = {kRight, 2.8f, 3.2f}, .wall_m = 0.25f};
  room.left = add_tinted_material(scene, "warm plaster", white, {0.98f, 0.86f, 0.70f});
  room.back = add_tinted_material(scene, "sage plaster", white, {0.60f, 0.74f, 0.62f});
  room.front = room.ceiling = white;
  room.floor = add_patterned_material(scene, "pale boards", glm::vec3(1.0f), 0.55f, 512, 1.4f,
                                      board_pattern({0.52f, 0.42f, 0.31f}, {0.74f, 0.64f, 0.50f}));
  room.floor_texture_m = 1.4f;
  add_room(scene, room, Tessellation{0.5f});
  const Tessellation coarse{0.5f};
  MeshBuilder wall;
  wall.set_material(white, 2.0f);
  add_pierced_slab(wall, {{kRight, 0, room.min.z}, {kRight + 0.25f, room.max.y, room.max.z}},
                   {kWindow}, coarse);

  // Two bars across the window and two upright, and its sill.
  const float x = kRight + 0.10f;
  for (int k = 1; k <= 2; ++k) {
    const float y = glm::mix(kWindow.min.y, kWindow.max.y, float(k) / 3.0f);
    add_box(wall, {x, y - 0.02f, kWindow.min.z}, {x + 0.05f, y + 0.02f, kWindow.max.z}, coarse);
  }
  for (int k = 1; k <= 2; ++k) {
    const float z = glm::mix(kWindow.min.z, kWindow.max.z, float(k) / 3.0f);
    add_box(wall, {x + 0.005f, kWindow.min.y, z - 0.025f}, {x + 0.045f, kWindow.max.y, z + 0.025f},
            coarse);
  }
  add_rounded_box(wall, {kRight - 0.08f, kWindow.min.y - 0.05f, kWindow.min.z - 0.08f},
                  {kRight + 0.12f, kWindow.min.y, kWindow.max.z + 0.08f}, 0.01f, coarse);
  add_mesh(scene, wall.finish("window wall"));
  room.right = white;
  add_skirting(scene, room, {.material = white, .height_m = 0.12f});
}

// Turned legs, an apron and a top with rounded edges.
void add_table(Scene& scene, int32_t wood) {
  constexpr glm::vec2 kHalf{0.85f, 0.48f};
  const Tessellation fine{0.10f};
  MeshBuilder builder;
  builder.set_material(wood, 1.0f);
  add_rounded_box(builder, {-kHalf.x, kTableHeight - 0.04f, -kHalf.y},
                  {kHalf.x, kTableHeight, kHalf.y}, 0.012f, Tessellation{0.15f});
  const glm::vec2 leg = kHalf - 0.10f;
  const float apron = kTableHeight - 0.045f;
  for (const float s : {-1.0f, 1.0f}) {
    add_rounded_box(builder, {-leg.x, apron - 0.10f, s * leg.y - 0.012f},
                    {leg.x, apron + 0.01f, s * leg.y + 0.012f}, 0.004f, Tessellation{0.3f});
    add_rounded_box(builder, {s * leg.x - 0.012f, apron - 0.10f, -leg.y},
                    {s * leg.x + 0.012f, apron + 0.01f, leg.y}, 0.004f, Tessellation{0.3f});
  }
  for (const float x : {-leg.x, leg.x}) {
    for (const float z : {-leg.y, leg.y}) {
      builder.set_transform({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {x, 0, z, 1}});
      Profile profile({0, 0}, fine);
      profile.line_to({0.018f, 0})
          .arc_to({0.026f, 0.05f}, 1.4f, 4)
          .arc_to({0.020f, 0.09f}, 1.4f, 4)
          .arc_to({0.033f, 0.36f}, -0.5f, 8)
          .arc_to({0.036f, 0.44f}, 1.6f, 5)
          .arc_to({0.024f, 0.50f}, -1.2f, 5)
          .arc_to({0.034f, 0.535f}, 2.2f, 5)
          .arc_to({0.030f, 0.56f}, 1.6f, 4)
          .line_to({0.030f, 0.59f})
          .line_to({0, 0.59f});
      add_lathe(builder, profile, 32);
      add_rounded_box(builder, {-0.036f, 0.58f, -0.036f}, {0.036f, apron + 0.01f, 0.036f}, 0.005f,
                      Tessellation{0.3f});
      builder.set_transform(glm::mat4(1.0f));
    }
  }
  const int32_t node = add_mesh(scene, builder.finish("table"));
  scene.nodes[node].translation = kTable;
}

// Faces +z; its seat is 0.45 m high.
void add_chair(Scene& scene, int32_t wood, int32_t seat, glm::vec3 place, float turn_rad) {
  const Tessellation coarse{0.2f};
  MeshBuilder builder;
  builder.set_material(wood, 1.0f);
  for (const float x : {-0.19f, 0.19f}) {
    add_rounded_box(builder, {x - 0.018f, 0, 0.155f}, {x + 0.018f, 0.44f, 0.191f}, 0.006f, coarse);
    add_rounded_box(builder, {x - 0.018f, 0, -0.205f}, {x + 0.018f, 0.93f, -0.169f}, 0.006f,
                    coarse);
    add_rounded_box(builder, {x - 0.010f, 0.20f, -0.18f}, {x + 0.010f, 0.23f, 0.17f}, 0.004f,
                    coarse);
  }
  for (const float y : {0.58f, 0.71f, 0.85f})
    add_rounded_box(builder, {-0.19f, y, -0.196f}, {0.19f, y + 0.055f, -0.178f}, 0.005f, coarse);
  add_rounded_box(builder, {-0.18f, 0.38f, 0.165f}, {0.18f, 0.43f, 0.183f}, 0.005f, coarse);
  builder.set_material(seat, 0.5f);
  add_rounded_box(builder, {-0.215f, 0.425f, -0.165f}, {0.215f, 0.465f, 0.215f}, 0.018f, coarse);
  const int32_t node = add_mesh(scene, builder.finish("chair"));
  scene.nodes[node].translation = place;
  scene.nodes[node].rotation = glm::angleAxis(turn_rad, glm::vec3(0, 1, 0));
}

void add_bowl_and_fruit(Scene& scene) {
  const int32_t glaze = add_material(scene, "blue glaze", {0.10f, 0.24f, 0.46f}, 0.3f);
  const glm::vec3 place = kTable + glm::vec3(0.05f, kTableHeight, 0.02f);
  MeshBuilder bowl;
  bowl.set_material(glaze);
  Profile profile({0, 0}, Tessellation{0.04f});
  profile.line_to({0.065f, 0})
      .arc_to({0.070f, 0.012f}, 1.2f, 3)
      .arc_to({0.175f, 0.095f}, 0.9f, 10)
      .arc_to({0.168f, 0.099f}, 2.6f, 4)
      .arc_to({0, 0.022f}, -1.0f, 12);
  add_lathe(bowl, profile, 64);
  scene.nodes[add_mesh(scene, bowl.finish("bowl"))].translation = place;

  struct Fruit {
    const char* name;
    glm::vec3 place;
    float radius;
    glm::vec3 albedo;
  };
  for (const Fruit& fruit :
       {Fruit{"red apple", {0.062f, 0.078f, 0.035f}, 0.046f, {0.62f, 0.05f, 0.04f}},
        Fruit{"green apple", {-0.055f, 0.076f, 0.048f}, 0.045f, {0.38f, 0.52f, 0.06f}},
        Fruit{"orange", {-0.008f, 0.080f, -0.064f}, 0.048f, {0.85f, 0.33f, 0.03f}},
        Fruit{"yellow apple", {0.004f, 0.140f, 0.004f}, 0.044f, {0.82f, 0.60f, 0.09f}}}) {
    MeshBuilder builder;
    builder.set_material(add_material(scene, fruit.name, fruit.albedo, 0.45f));
    add_sphere(builder, {}, fruit.radius, 40, [](glm::vec3 d) {
      const float dimple = std::exp(-14.0f * (d.x * d.x + d.z * d.z));
      return 0.95f + 0.05f * (1.0f - d.y * d.y) - (d.y > 0 ? 0.22f : 0.10f) * dimple;
    });
    const int32_t node = add_mesh(scene, builder.finish(fruit.name));
    scene.nodes[node].translation = place + fruit.place;
    scene.nodes[node].rotation = glm::angleAxis(4.0f * fruit.place.x, glm::vec3(0, 0, 1));
  }
}

void add_jug_and_books(Scene& scene) {
  const int32_t clay = add_material(scene, "white glaze", {0.82f, 0.79f, 0.72f}, 0.35f);
  MeshBuilder jug;
  jug.set_material(clay);
  Profile profile({0, 0}, Tessellation{0.04f});
  profile.line_to({0.058f, 0})
      .arc_to({0.064f, 0.010f}, 1.3f, 3)
      .arc_to({0.050f, 0.180f}, 1.5f, 14)
      .arc_to({0.046f, 0.265f}, -0.9f, 8)
      .arc_to({0.040f, 0.265f}, 3.0f, 4)
      .arc_to({0.042f, 0.185f}, 0.7f, 6)
      .line_to({0, 0.180f});
  add_lathe(jug, profile, 56);
  const auto handle = [](float t) {
    const float a = 2 * kPi * t;
    return glm::vec3(0.062f + 0.040f * std::cos(a), 0.185f + 0.062f * std::sin(a), 0.0f);
  };
  add_closed_tube(jug, handle, 0.0095f, 48, 12);
  const int32_t node = add_mesh(scene, jug.finish("jug"));
  scene.nodes[node].translation = kTable + glm::vec3(-0.42f, kTableHeight, -0.14f);
  scene.nodes[node].rotation = glm::angleAxis(-0.6f, glm::vec3(0, 1, 0));

  struct Book {
    glm::vec3 half_size;
    float turn_rad;
    glm::vec3 albedo;
  };
  const int32_t pages = add_material(scene, "paper", {0.80f, 0.76f, 0.66f}, 0.95f);
  float y = kTableHeight;
  for (const Book& book : {Book{{0.125f, 0.019f, 0.09f}, 0.25f, {0.48f, 0.09f, 0.08f}},
                           Book{{0.110f, 0.014f, 0.08f}, -0.15f, {0.10f, 0.28f, 0.26f}},
                           Book{{0.100f, 0.016f, 0.07f}, 0.50f, {0.72f, 0.55f, 0.20f}}}) {
    const glm::vec3 h = book.half_size;
    MeshBuilder builder;
    const Tessellation coarse{0.2f};
    builder.set_material(add_material(scene, "book cover", book.albedo, 0.7f));
    add_rounded_box(builder, {-h.x, 0, -h.z}, {h.x, 0.004f, h.z}, 0.0015f, coarse);
    add_rounded_box(builder, {-h.x, 2 * h.y - 0.004f, -h.z}, {h.x, 2 * h.y, h.z}, 0.0015f, coarse);
    add_rounded_box(builder, {-h.x, 0.001f, -h.z}, {-h.x + 0.006f, 2 * h.y - 0.001f, h.z}, 0.002f,
                    coarse);
    builder.set_material(pages);
    add_box(builder, {-h.x + 0.004f, 0.003f, -h.z + 0.004f},
            {h.x - 0.004f, 2 * h.y - 0.003f, h.z - 0.004f}, coarse);
    const int32_t placed = add_mesh(scene, builder.finish("book"));
    scene.nodes[placed].translation = kTable + glm::vec3(0.52f, y, -0.10f);
    scene.nodes[placed].rotation = glm::angleAxis(book.turn_rad, glm::vec3(0, 1, 0));
    y += 2 * h.y;
  }
}

// A framed picture on the back wall: hills in three tones.
void add_picture(Scene& scene, int32_t wood) {
  const Pattern hills = {[](glm::vec2 uv) {
                           const float far = 0.45f + 0.08f * std::sin(2 * kPi * uv.x + 1.0f);
                           const float near = 0.66f + 0.10f * std::sin(2 * kPi * uv.x + 3.4f);
                           const float brush = 0.9f + 0.2f * tiling_noise(uv, 8, 4, 101);
                           if (uv.y > near) return glm::vec3(0.16f, 0.20f, 0.09f) * brush;
                           if (uv.y > far) return glm::vec3(0.24f, 0.34f, 0.36f) * brush;
                           return glm::mix(glm::vec3(0.62f, 0.70f, 0.76f),
                                           glm::vec3(0.86f, 0.66f, 0.46f), uv.y / far) *
                                  brush;
                         },
                         [](glm::vec2 uv) { return 0.001f * tiling_noise(uv, 32, 3, 102); }};
  const int32_t canvas =
      add_patterned_material(scene, "canvas", glm::vec3(1.0f), 0.8f, 256, 1.0f, hills);
  const Tessellation coarse{0.3f};
  const glm::vec3 low(-1.0f, 1.25f, -2.11f), high(0.0f, 2.0f, -2.07f);
  MeshBuilder builder;
  builder.set_material(wood, 1.0f);
  constexpr float kFrame = 0.05f;
  for (const float y : {low.y, high.y - kFrame})
    add_rounded_box(builder, {low.x, y, low.z}, {high.x, y + kFrame, high.z}, 0.010f, coarse);
  for (const float x : {low.x, high.x - kFrame})
    add_rounded_box(builder, {x, low.y, low.z}, {x + kFrame, high.y, high.z}, 0.010f, coarse);
  builder.set_material(canvas, 1.0f);
  add_box(builder, {low.x + 0.02f, low.y + 0.02f, low.z}, {high.x - 0.02f, high.y - 0.02f, -2.09f},
          coarse);
  add_mesh(scene, builder.finish("picture"));
}

void add_sun(Scene& scene) {
  Light sun;
  sun.name = "sun";
  sun.kind = LightKind::directional;
  sun.color = {1.0f, 0.90f, 0.74f};
  sun.intensity = kSunLux;
  const glm::vec3 window(kRight + 1.0f, 2.12f, 0.55f);
  sun.node = add_node(scene, "sun", window);

  // Let the patch wander along the wall.
  animate_rotation(scene, sun.node, 40, [](float phase) {
    return look_along(kSunDirection + glm::vec3(0, 0, 0.05f * std::sin(2 * kPi * phase)));
  });
  scene.lights.push_back(sun);
  scene.exposure_ev = 1.1f + exposure_for(0.75f, kSunLux);
}

}  // namespace

Scene make_table() {
  Scene scene;
  scene.name = "table";
  const glm::vec3 target{-0.78f, 0.86f, -0.7f};
  const auto eye = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(1.55f + 0.20f * std::sin(angle), 1.42f + 0.08f * std::sin(2 * angle), 2.55f);
  };
  const int32_t camera = add_camera(scene, "room", eye(0), target, 0.78f);
  animate_camera(scene, camera, 40, eye, [=](float) { return target; });
  add_camera(scene, "below", {1.35f, 0.62f, 1.55f}, {-0.70f, 0.28f, -0.6f}, 0.70f);
  add_walls(scene);
  const int32_t wood = add_patterned_material(scene, "wood", glm::vec3(1.0f), 0.5f, 256, 1.0f,
                                              board_pattern(kOakDark, kOakLight));
  const int32_t linen = add_patterned_material(scene, "linen", {0.70f, 0.22f, 0.14f}, 0.95f, 256,
                                               0.5f, cloth_pattern());
  add_table(scene, wood);
  add_chair(scene, wood, linen, {0.75f, 0, -0.45f}, -kPi / 2 - 0.35f);
  add_chair(scene, wood, linen, {-0.75f, 0, -1.32f}, 0.15f);
  add_bowl_and_fruit(scene);
  add_jug_and_books(scene);
  add_picture(scene, wood);
  add_sun(scene);
  return scene;
}

}  // namespace lueur::builtin
