// SPDX-License-Identifier: MIT
// A dark room where one tight spotlight meets nothing but the floor: all that the objects around
// the disc show is light that came off the floor, mostly from below.
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

constexpr float kSpotHeight = 6.0f;   // m
constexpr float kDiscRadius = 1.85f;  // m, where the spot's light ends
constexpr float kFloorAlbedo = 0.72f;

// A trefoil knot lying in a torus, standing upright; about 2 m wide.
glm::vec3 knot_curve(float t) {
  const float angle = 2 * kPi * t;
  const float r = 0.62f + 0.24f * std::cos(3 * angle);
  return {r * std::cos(2 * angle), r * std::sin(2 * angle), 0.24f * std::sin(3 * angle)};
}

// A chess-like figure: foot, waist, collar and head.
void add_figure(MeshBuilder& builder, const Tessellation& tessellation) {
  Profile profile({0, 0}, tessellation);
  profile.line_to({0.42f, 0})
      .arc_to({0.40f, 0.14f}, 2.4f, 6)
      .arc_to({0.33f, 0.22f}, -1.2f, 6)
      .arc_to({0.15f, 1.05f}, -0.7f, 16)
      .arc_to({0.20f, 1.30f}, -0.8f, 8)
      .arc_to({0.24f, 1.36f}, 1.8f, 6)
      .arc_to({0.16f, 1.42f}, 1.2f, 6)
      .arc_to({0.13f, 1.50f}, -1.0f, 6)
      .arc_to({0, 1.98f}, 3.6f, 24);
  add_lathe(builder, profile, 64);
}

void add_room(Scene& scene) {
  const int32_t grey = add_material(scene, "floor", glm::vec3(kFloorAlbedo), 1.0f);
  const int32_t plaster = add_material(scene, "wall", {0.72f, 0.70f, 0.66f}, 1.0f);
  const Tessellation tessellation{0.25f};
  MeshBuilder floor;
  floor.set_material(grey);
  add_box(floor, {-9, -0.3f, -4.5f}, {9, 0, 7.5f}, tessellation,
          kNegativeX | kPositiveX | kNegativeY | kNegativeZ | kPositiveZ);
  add_mesh(scene, floor.finish("floor"));
  MeshBuilder wall;
  wall.set_material(plaster);
  add_box(wall, {-9, -0.3f, -4.8f}, {9, 5.5f, -4.5f}, tessellation,
          kNegativeX | kPositiveX | kNegativeY | kPositiveY | kNegativeZ);
  add_mesh(scene, wall.finish("back wall"));
}

// Adds one object with a material of its own; returns its node.
template <class Add>
int32_t add_object(Scene& scene, const char* name, glm::vec3 albedo, glm::vec3 place, Add&& add) {
  const int32_t material = add_material(scene, name, albedo, 0.7f);
  MeshBuilder builder;
  builder.set_material(material);
  add(builder);
  const int32_t node = add_mesh(scene, builder.finish(name));
  scene.nodes[node].translation = place;
  return node;
}

void add_objects(Scene& scene) {
  const Tessellation fine{0.06f};
  const auto sphere = [](float radius) {
    return [radius](MeshBuilder& builder) { add_sphere(builder, {0, radius, 0}, radius, 72); };
  };
  const auto cylinder = [&](float radius, float height) {
    return [=](MeshBuilder& builder) {
      Profile profile({0, 0}, fine);
      profile.line_to({radius - 0.03f, 0})
          .arc_to({radius, 0.03f}, kPi / 2, 3)
          .line_to({radius, height - 0.03f})
          .arc_to({radius - 0.03f, height}, kPi / 2, 3)
          .line_to({0, height});
      add_lathe(builder, profile, 72);
    };
  };
  const auto box = [&](glm::vec3 half_size) {
    return [=](MeshBuilder& builder) {
      add_box(builder, {-half_size.x, 0, -half_size.z}, {half_size.x, 2 * half_size.y, half_size.z},
              Tessellation{0.08f});
    };
  };

  const int32_t knot = add_object(
      scene, "torus knot", {0.80f, 0.10f, 0.07f}, {0, 1.35f, -2.75f},
      [](MeshBuilder& builder) { add_closed_tube(builder, knot_curve, 0.17f, 320, 28); });
  animate_rotation(scene, knot, 40,
                   [](float phase) { return glm::angleAxis(2 * kPi * phase, glm::vec3(0, 1, 0)); });
  add_object(scene, "white sphere", glm::vec3(0.85f), {-2.3f, 0, -1.75f}, sphere(0.65f));
  add_object(scene, "green sphere", {0.10f, 0.60f, 0.14f}, {-2.35f, 0, 1.15f}, sphere(0.5f));
  add_object(scene, "yellow sphere", {0.85f, 0.62f, 0.06f}, {2.35f, 0, 1.3f}, sphere(0.42f));
  add_object(scene, "white box", glm::vec3(0.82f), {-3.6f, 0, -0.2f}, box({0.5f, 1.3f, 0.5f}));
  add_object(scene, "blue box", {0.08f, 0.18f, 0.70f}, {3.7f, 0, -0.7f}, box({0.55f, 0.9f, 0.55f}));
  add_object(scene, "orange cylinder", {0.85f, 0.33f, 0.05f}, {-1.55f, 0, -3.45f},
             cylinder(0.38f, 2.3f));
  add_object(scene, "violet cylinder", {0.42f, 0.10f, 0.60f}, {1.8f, 0, -3.5f},
             cylinder(0.45f, 1.6f));
  add_object(scene, "figure", glm::vec3(0.85f), {2.3f, 0, -1.6f},
             [&](MeshBuilder& builder) { add_figure(builder, fine); });
}

}  // namespace

Scene make_spot_floor() {
  Scene scene;
  scene.name = "spot-floor";
  const glm::vec3 target{0, 0.8f, -0.9f};
  const int32_t camera = add_camera(scene, "front", {0, 2.3f, 7.2f}, target, 0.72f);
  animate_camera(
      scene, camera, 40,
      [](float phase) {
        const float angle = 2 * kPi * phase;
        return glm::vec3(7.2f * std::sin(0.35f * std::sin(angle)),
                         2.3f - 0.6f * std::sin(2 * angle),
                         7.2f * std::cos(0.35f * std::sin(angle)));
      },
      [=](float) { return target; });
  add_room(scene);
  add_objects(scene);

  // Hang the light above the middle; its disc wanders a little and never touches an object.
  Light spot;
  spot.name = "spot";
  spot.kind = LightKind::spot;
  spot.node = add_node(scene, "spot", {0, kSpotHeight, 0}, look_along({0, -1, 0}));
  spot.color = {1.0f, 0.96f, 0.90f};
  spot.intensity = 20'000.0f;
  spot.outer_cone_rad = std::atan(kDiscRadius / kSpotHeight);
  spot.inner_cone_rad = 0.85f * spot.outer_cone_rad;
  scene.lights.push_back(spot);
  animate_translation(scene, spot.node, 40, [](float phase) {
    return glm::vec3(0.2f * std::sin(2 * kPi * phase), kSpotHeight, 0);
  });

  // Expose the disc one stop over: everything else in the picture is lit by it.
  scene.exposure_ev =
      1.0f + exposure_for(kFloorAlbedo, spot.intensity / (kSpotHeight * kSpotHeight));
  return scene;
}

}  // namespace lueur::builtin
