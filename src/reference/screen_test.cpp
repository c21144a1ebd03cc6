// SPDX-License-Identifier: MIT
// `screen`: what the camera does not see gives nothing.
#include <algorithm>
#include <cmath>

#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::reference {
namespace {

float brightest(const Rendering& rendering) {
  const ImageF& indirect = layer(rendering, "indirect");
  return *std::max_element(indirect.samples.begin(), indirect.samples.end());
}

// A black floor that the camera looks down at, and a glowing quad that lights it.
struct Lit {
  Scene scene;
  glm::dvec3 corner, u, v;
};
Lit floor_lit_by(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                 bool double_sided = true) {
  Lit lit{scene_seen_from({0, 2, 2}, {0, 0, 0}), corner, u, v};
  lit.scene.materials[0].specular = 0.0f;
  lit.scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  add_floor(lit.scene, 0.7f);
  const int32_t glow = add_diffuse(lit.scene, 0, 1);
  lit.scene.materials.back().double_sided = double_sided;
  add_quad(lit.scene, corner, u, v, glow);
  return lit;
}

void expect_path_has_the_light(const Lit& lit) {
  const Estimates found = estimates(lit.scene, kShot, {.spp = 16}, 64);
  const ImageF normal =
      layer(rendered(lit.scene, kShot, {.mode = Mode::ambient, .spp = 8}), "normal");
  const auto rays = rays_of(lit.scene, kShot);
  expect_unbiased(found, [&](size_t i) -> std::optional<double> {
    if (!(normal.samples[3 * i + 1] > 0.5f)) return std::nullopt;
    const auto p = meet_plane(rays[i], {}, {0, 1, 0});
    return polygon_share(*p, {0, 1, 0}, quad_corners(lit.corner, lit.u, lit.v));
  });
}

Rendering screen_of(const Scene& scene, uint32_t bounces = 1) {
  return rendered(scene, kShot, {.mode = Mode::screen, .bounces = bounces, .spp = 64});
}

TEST(Screen, NothingFromBehindTheCamera) {
  const Lit lit = floor_lit_by({-2, 0.5f, 3}, {4, 0, 0}, {0, 3, 0});
  EXPECT_EQ(brightest(screen_of(lit.scene)), 0.0f);
  expect_path_has_the_light(lit);
}

TEST(Screen, NothingFromBesideThePicture) {
  const Lit lit = floor_lit_by({2.5f, 0, -1}, {0, 0, 2}, {0, 1, 0});
  EXPECT_EQ(brightest(screen_of(lit.scene)), 0.0f);
  expect_path_has_the_light(lit);
}

// Between camera and floor, its lit side to the floor. Two-sided, it hides the floor.
TEST(Screen, NothingFromWhatFacesAway) {
  const Lit lit = floor_lit_by({-0.2f, 0.5f, -0.2f}, {0.4f, 0, 0}, {0, 0, 0.4f}, false);
  EXPECT_EQ(brightest(screen_of(lit.scene)), 0.0f);
  expect_path_has_the_light(lit);
}

// Camera and floor are both behind a one-sided light: light has no sides, but the camera sees
// nothing there.
TEST(Screen, NothingFromTheBackOfWhatTheCameraLooksThrough) {
  const Lit one_sided = floor_lit_by({0.5f, 0, -0.5f}, {-1, 0, 0}, {0, 0.5f, 0}, false);
  EXPECT_EQ(brightest(screen_of(one_sided.scene)), 0.0f);
  expect_path_has_the_light(one_sided);
  const Lit two_sided = floor_lit_by({0.5f, 0, -0.5f}, {-1, 0, 0}, {0, 0.5f, 0}, true);
  EXPECT_GT(brightest(screen_of(two_sided.scene)), 0.1f);
}

// A wall at the far side, which the camera sees over the floor, and something before it.
Lit wall_scene() {
  return floor_lit_by({-0.5f, 0, -0.6f}, {1, 0, 0}, {0, 0.5f, 0}, false);
}

// Mirrored in its own plane the wall still shows its front; turned over, its back.
TEST(Screen, MirroredFrontsAreFronts) {
  Lit lit = wall_scene();
  const ImageF plain = layer(screen_of(lit.scene), "indirect");
  Node& node = lit.scene.nodes[static_cast<size_t>(lit.scene.instances[1].node)];
  node.scale = {-1, 1, 1};
  const ImageF mirrored = layer(screen_of(lit.scene), "indirect");
  double sums[2] = {};
  for (size_t k = 0; k < plain.samples.size(); ++k) {
    sums[0] += static_cast<double>(plain.samples[k]);
    sums[1] += static_cast<double>(mirrored.samples[k]);
  }
  EXPECT_GT(sums[0], 0.0);
  // 300 pixels of 64 samples: 1 / sqrt(19200), four times.
  EXPECT_NEAR(sums[1], sums[0], 0.03 * sums[0]);
  node.scale = {1, 1, -1};
  node.translation = {0, 0, -1.2f};
  EXPECT_EQ(brightest(screen_of(lit.scene)), 0.0f);
  EXPECT_GT(brightest(rendered(lit.scene, kShot, {.spp = 64})), 0.1f);
}

TEST(Screen, NothingFromWhatIsHidden) {
  for (const bool solid : {false, true}) {
    Lit lit = wall_scene();
    const int32_t black = builtin::add_material(lit.scene, "black", glm::vec3(0.0f));
    if (solid) {
      builtin::MeshBuilder builder;
      builder.set_material(black);
      builtin::add_box(builder, {-0.7f, 0.55f, 0.2f}, {0.7f, 1.3f, 0.3f}, {.edge_m = 2.0f});
      builtin::add_mesh(lit.scene, builder.finish("block"));
    } else {
      // One-sided, its front to the camera.
      add_quad(lit.scene, {-0.7f, 0.55f, 0.25f}, {1.4f, 0, 0}, {0, 0.65f, 0}, black);
    }
    EXPECT_EQ(brightest(screen_of(lit.scene)), 0.0f) << (solid ? "solid" : "sheet");
    EXPECT_GT(brightest(rendered(lit.scene, kShot, {.spp = 64})), 0.1f);
  }
}

// A one-sided sheet with its back to the camera hides nothing from it, nor does what is nearer than
// the near plane.
TEST(Screen, WhatTheCameraLooksThroughHidesNothing) {
  Scene unhidden = wall_scene().scene;
  unhidden.cameras[0].near_m = 0.3f;
  const Rendering free = screen_of(unhidden);
  EXPECT_GT(brightest(free), 0.1f);
  for (const bool near : {false, true}) {
    Lit lit = wall_scene();
    lit.scene.cameras[0].near_m = 0.3f;
    const int32_t black = builtin::add_material(lit.scene, "black", glm::vec3(0.0f));
    if (near) {
      add_quad(lit.scene, {-0.7f, 1.9f, 1.9f}, {1.4f, 0, 0}, {0, 0.2f, -0.1f}, black);
    } else {
      add_quad(lit.scene, {0.7f, 0.55f, 0.25f}, {-1.4f, 0, 0}, {0, 0.65f, 0}, black);
    }
    const Rendering through = screen_of(lit.scene);
    // The sheet takes light from no one: it stands above what the floor sees of the wall.
    EXPECT_TRUE(layer(through, "depth").samples == layer(free, "depth").samples);
    EXPECT_TRUE(layer(through, "indirect").samples == layer(free, "indirect").samples);
  }
}

// What is nearer than the near plane is not seen, and so gives no light. The camera looks down at
// 45 degrees: of the wall, at z = -0.6, it sees what is lower than y = 4.6 - sqrt(2) near.
TEST(Screen, NothingFromBeforeTheNearPlane) {
  Lit lit = wall_scene();
  constexpr float kNear = 3.05f;
  lit.scene.cameras[0].near_m = kNear;
  const double top = 4.6 - std::sqrt(2.0) * static_cast<double>(kNear);
  const auto seen = quad_corners(lit.corner, lit.u, {0, top, 0});
  // Of the floor it sees a narrow strip.
  const Shot shot{64, 64};
  const Settings settings{.mode = Mode::screen, .spp = 16};
  const ImageF normal = layer(rendered(lit.scene, shot, settings), "normal");
  const auto rays = rays_of(lit.scene, shot);
  expect_unbiased(estimates(lit.scene, shot, settings, 64), [&](size_t i) -> std::optional<double> {
    const auto p = meet_plane(rays[i], {}, {0, 1, 0});
    // Beside the wall the camera sees the floor behind it, too.
    if (!(normal.samples[3 * i + 1] > 0.5f) || p->z < -0.59) return std::nullopt;
    return polygon_share(*p, {0, 1, 0}, seen);
  });
}

// Punctual light by way of the wall: the same rules.
TEST(Screen, ReflectedLightComesFromWhatIsSeenOnly) {
  for (const bool seen : {true, false}) {
    Scene scene = scene_seen_from({0, 2, 2}, {0, 0, 0});
    scene.materials[0].specular = 0.0f;
    add_floor(scene, 0.7f);
    const float z = seen ? -0.6f : 3.0f;
    add_quad(scene, {-2, 0, z}, {4, 0, 0}, {0, 0.5f, 0}, add_diffuse(scene, 0.8f));
    add_light(scene, LightKind::directional, 1.0f, {}, {0, 0, seen ? -1.0f : 1.0f});
    const Rendering screen = screen_of(scene);
    const Rendering path = rendered(scene, kShot, {.spp = 64});
    EXPECT_GT(brightest(path), 0.001f);
    if (seen) {
      EXPECT_GT(brightest(screen), 0.01f);
    } else {
      EXPECT_EQ(brightest(screen), 0.0f);
    }
  }
}

// From a lit wall behind the camera by way of one that the camera sees: it must see both.
TEST(Screen, EverySurfaceOnTheWayMustBeSeen) {
  Scene scene = scene_seen_from({0, 2, 2}, {0, 0, 0});
  scene.materials[0].specular = 0.0f;
  add_floor(scene, 0.7f);
  const int32_t white = add_diffuse(scene, 0.8f);
  add_quad(scene, {-2, 0, -0.6f}, {4, 0, 0}, {0, 0.5f, 0}, white);
  add_quad(scene, {2, 0, 3}, {-4, 0, 0}, {0, 2, 0}, white);
  add_light(scene, LightKind::directional, 1.0f, {}, {0, 0, 1});
  EXPECT_EQ(brightest(screen_of(scene, 3)), 0.0f);
  EXPECT_GT(brightest(rendered(scene, kShot, {.bounces = 2, .spp = 64})), 0.001f);
}

}  // namespace
}  // namespace lueur::reference
