// SPDX-License-Identifier: MIT
// A hall with a light of each kind: a sun that enters through an opening in the roof, a spotlight
// on a red wall, and a bulb behind a screen. None shines on the block, nor, at first, on the ball:
// they show by colour and side what each of the three gives.
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/room_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"

namespace lueur::builtin {
namespace {

constexpr glm::vec3 kHallMin{-5.0f, 0.0f, -4.0f},
    kHallMax{5.0f, 4.5f, 5.5f};    // m, the hall's inside
constexpr float kHallWall = 0.3f;  // m
constexpr float kHallLux = 1'200.0f, kHallAlbedo = 0.8f;

struct HallSurfaces {
  int32_t plaster, red, blue, floor;
};

HallSurfaces add_hall_surfaces(Scene& scene) {
  HallSurfaces s;
  s.plaster = add_patterned_material(scene, "plaster", glm::vec3(0.9f, 0.88f, 0.84f), 0.95f, 256,
                                     2.0f, plaster_pattern());
  s.red = add_tinted_material(scene, "red plaster", s.plaster, {0.80f, 0.14f, 0.08f});
  s.blue = add_tinted_material(scene, "blue plaster", s.plaster, {0.10f, 0.22f, 0.70f});
  s.floor =
      add_patterned_material(scene, "tiles", glm::vec3(0.9f), 0.7f, 512, 2.0f, tile_pattern());
  return s;
}

void add_hall(Scene& scene, const HallSurfaces& s) {
  const Tessellation tessellation{1.0f};
  Room room{.min = kHallMin, .max = kHallMax, .wall_m = kHallWall};
  room.left = s.red;
  room.right = room.back = room.front = s.plaster;
  room.floor = s.floor;
  add_room(scene, room, tessellation);
  add_skirting(scene, room, {.material = s.plaster});

  // Let the sun in by a long opening.
  MeshBuilder roof;
  roof.set_material(s.plaster);
  add_pierced_slab(
      roof,
      {{kHallMin.x - kHallWall, kHallMax.y, kHallMin.z - kHallWall},
       {kHallMax.x + kHallWall, kHallMax.y + kHallWall, kHallMax.z + kHallWall}},
      {{{0.6f, kHallMax.y - 0.1f, -3.2f}, {2.0f, kHallMax.y + kHallWall + 0.1f, 1.2f}}},
      tessellation);
  add_mesh(scene, roof.finish("roof"));

  // A screen, blue towards the bulb behind it.
  MeshBuilder screen;
  screen.set_material(s.blue);
  add_rounded_box(screen, {-1.9f, 0, -2.2f}, {-1.7f, 2.6f, -0.2f}, 0.02f, tessellation);
  add_mesh(scene, screen.finish("screen"));
}

void add_hall_things(Scene& scene, const HallSurfaces& s) {
  MeshBuilder ball;
  ball.set_material(s.plaster);
  add_sphere(ball, {0, 0.75f, 0}, 0.75f, 72);
  const int32_t node = add_mesh(scene, ball.finish("ball"));
  const glm::vec3 place{0.1f, 0, 0.6f};
  scene.nodes[node].translation = place;
  animate_translation(scene, node, 40, [=](float phase) {
    return place + glm::vec3(1.2f * std::sin(2 * kPi * phase), 0, 0);
  });
  MeshBuilder block;
  block.set_material(s.plaster);
  add_rounded_box(block, {2.9f, 0, -2.6f}, {4.1f, 1.5f, -1.4f}, 0.03f, Tessellation{0.5f});
  add_mesh(scene, block.finish("block"));
}

Light hall_light(const char* name, LightKind kind, int32_t node, glm::vec3 color, float intensity) {
  Light made;
  made.name = name;
  made.kind = kind;
  made.node = node;
  made.color = color;
  made.intensity = intensity;
  return made;
}

}  // namespace

Scene make_three_lights() {
  Scene scene;
  scene.name = "three-lights";
  const glm::vec3 target{-0.3f, 1.5f, -1.5f};
  const auto eye = [](float phase) {
    return glm::vec3(0.5f * std::sin(2 * kPi * phase), 1.9f, 5.0f);
  };
  const int32_t camera = add_camera(scene, "front", eye(0), target, 0.95f);
  animate_camera(scene, camera, 40, eye, [=](float) { return target; });
  const HallSurfaces surfaces = add_hall_surfaces(scene);
  add_hall(scene, surfaces);
  add_hall_things(scene, surfaces);

  const glm::vec3 sunward{1.0f, 10.0f, -1.2f}, sunlit{1.6f, 0, -0.6f};
  scene.lights.push_back(hall_light("sun", LightKind::directional,
                                    add_node(scene, "sun", sunward, look_along(sunlit - sunward)),
                                    {1.0f, 0.95f, 0.85f}, kHallLux));
  add_spot_light(scene, "spot", {1.5f, 4.2f, 4.0f}, {kHallMin.x, 1.7f, -1.0f}, {1.0f, 0.9f, 0.8f},
                 kHallLux, 0.2f);
  // Along its node's axis it meets the screen.
  const glm::vec3 bulb{-2.6f, 1.5f, -1.2f};
  scene.lights.push_back(hall_light("bulb", LightKind::point,
                                    add_node(scene, "bulb", bulb, look_along(glm::vec3(1, 0, 0))),
                                    {1.0f, 0.8f, 0.55f}, 0.2f * kHallLux));
  // A stop over: most of the picture is lit by what these light.
  scene.exposure_ev = 1.0f + exposure_for(kHallAlbedo, kHallLux);
  return scene;
}

}  // namespace lueur::builtin
