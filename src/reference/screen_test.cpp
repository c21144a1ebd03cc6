// SPDX-License-Identifier: MIT
// `screen` and `screen_unoccluded`: what the camera does not see gives nothing; what it sees is
// summed as HSSIL writes it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::reference {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Shot kShot{24, 24};

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

// A room with all that the sum can meet: slanted faces, several colours, what faces away, nothing.
Scene sum_scene() {
  Scene scene = scene_seen_from({0.5f, 1.1f, 2.4f}, {0, 0.4f, 0});
  scene.materials[0].base_color = glm::vec4(0.8f, 0.5f, 0.2f, 1);
  add_floor(scene, 1);
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0}, add_diffuse(scene, 0.6f, 0.3f));
  builtin::MeshBuilder builder;
  builtin::add_sphere(builder, {0.3f, 0.3f, 0}, 0.3f, 24);
  builtin::add_mesh(scene, builder.finish("ball"));
  add_light(scene, LightKind::point, 5.0f, {0.8f, 1.5f, 1});
  return scene;
}

// HSSIL (4) or (3) in double precision, from the depth, normal and source that come with it.
std::vector<double> sum_over_pixels(const Scene& scene, const Rendering& r, bool disc) {
  const auto rays = rays_of(scene, kShot);
  const ImageF &depth = layer(r, "depth"), &normal = layer(r, "normal"),
               &source = layer(r, "source");
  const double side =
      2 * std::tan(0.5 * static_cast<double>(scene.cameras[0].vertical_fov_rad)) / kShot.height;
  const auto position = [&](size_t i) {
    return rays[i].origin + static_cast<double>(depth.samples[i]) * rays[i].direction;
  };
  const auto normal_at = [&](size_t i) {
    return glm::dvec3(normal.samples[3 * i], normal.samples[3 * i + 1], normal.samples[3 * i + 2]);
  };
  std::vector<double> sums(3 * rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    if (depth.samples[i] == 0.0f) continue;
    for (size_t j = 0; j < rays.size(); ++j) {
      if (depth.samples[j] == 0.0f) continue;
      const glm::dvec3 way = position(j) - position(i);
      const double r2 = glm::dot(way, way);
      if (!(r2 > 0)) continue;
      const double cos_x = std::max(glm::dot(normal_at(i), way) / std::sqrt(r2), 0.0);
      const double cos_y = std::max(-glm::dot(normal_at(j), way) / std::sqrt(r2), 0.0);
      const double z = static_cast<double>(depth.samples[j]);
      // The ray is 1 long along the axis, so cos(alpha) / cos(beta) is 1 / -(n . ray), at most 20.
      const double facing = std::max(-glm::dot(normal_at(j), rays[j].direction), 1.0 / 20);
      const double ds = side * side * z * z / facing;
      const double big_r2 = cos_y * ds / kPi;
      const double factor = big_r2 * cos_x / (disc ? r2 + big_r2 : r2);
      for (size_t c = 0; c < 3; ++c)
        sums[3 * i + c] += factor * static_cast<double>(source.samples[3 * j + c]);
    }
  }
  return sums;
}

TEST(ScreenUnoccluded, EqualsTheSumInDoublePrecision) {
  const Scene scene = sum_scene();
  for (const FormFactor factor : {FormFactor::disc, FormFactor::point}) {
    const Rendering r =
        rendered(scene, kShot, {.mode = Mode::screen_unoccluded, .spp = 0, .form_factor = factor});
    EXPECT_TRUE(r.complete);
    const auto sums = sum_over_pixels(scene, r, factor == FormFactor::disc);
    const ImageF& indirect = layer(r, "indirect");
    // Positions are floats of about 1 m, 1e-7 off, and the nearest neighbours, which weigh most,
    // 0.05 m apart at grazing angles, where an error of 1e-7 m counts against a height of 1e-3 m.
    for (size_t k = 0; k < sums.size(); ++k)
      EXPECT_NEAR(indirect.samples[k], sums[k], 1e-4 * sums[k] + 1e-7) << "channel " << k;
    EXPECT_GT(*std::max_element(sums.begin(), sums.end()), 0.1);
  }
}

// One pass sums every third of 576 pixels; seeds 0, 1 and 2 begin with different thirds.
TEST(ScreenUnoccluded, PartsMakeTheWhole) {
  const Scene scene = sum_scene();
  Settings settings{.mode = Mode::screen_unoccluded, .spp = 0};
  const ImageF whole = layer(rendered(scene, kShot, settings), "indirect");
  const Rendering all = rendered(scene, kShot, settings);
  const uint32_t passes = all.progress.spp_done / 256;
  ASSERT_GT(passes, 1u);
  settings.spp = 1;
  std::vector<double> mean(whole.samples.size());
  bool differ = false;
  for (settings.seed = 0; settings.seed < passes; ++settings.seed) {
    const Rendering part = rendered(scene, kShot, settings);
    EXPECT_EQ(part.progress.spp_done, 256u);
    const ImageF& indirect = layer(part, "indirect");
    for (size_t k = 0; k < mean.size(); ++k)
      mean[k] += static_cast<double>(indirect.samples[k]) / passes;
    differ = differ || indirect.samples != whole.samples;
  }
  EXPECT_TRUE(differ);
  for (size_t k = 0; k < mean.size(); ++k)
    EXPECT_NEAR(mean[k], whole.samples[k], 1e-6 * mean[k]) << k;
  // More samples than there are pixels: all of them, once.
  settings = {.mode = Mode::screen_unoccluded, .spp = 1u << 20};
  EXPECT_EQ(layer(rendered(scene, kShot, settings), "indirect").samples, whole.samples);
}

// A glowing wall stands on a floor: the sum over its pixels approaches the polygon's closed form.
TEST(ScreenUnoccluded, WallOverFloor) {
  Scene scene = scene_seen_from({0, 1.5f, 2.6f}, {0, 0.3f, 0});
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  scene.materials[0].specular = 0.0f;
  add_floor(scene, 1);
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0}, add_diffuse(scene, 0, 1));
  const Shot shot{64, 64};
  const Rendering r = rendered(scene, shot, {.mode = Mode::screen_unoccluded, .spp = 0});
  const ImageF &indirect = layer(r, "indirect"), &normal = layer(r, "normal");
  const auto wall = quad_corners({-1, 0, -1}, {2, 0, 0}, {0, 1, 0});
  // A pixel covers 4 cm at 3 m, and the wall 50 x 25 of them: its outline is off by at most half a
  // pixel at each of three sides, 1 to 2 % each, mostly cancelling; 0.5 m away the discs' own
  // approximation is R^2 / r^2 = 0.04^2 / (pi 0.5^2) = 0.2 %.
  int held = 0;
  for (const PixelRay& ray : rays_of(scene, shot)) {
    if (!(normal.at(ray.x, ray.y, 1) > 0.99f)) continue;
    const auto p = meet_plane(ray, {}, {0, 1, 0});
    if (p->z < -0.5) continue;
    const double exact = polygon_share(*p, {0, 1, 0}, wall);
    EXPECT_NEAR(indirect.at(ray.x, ray.y, 0), exact, 0.04 * exact) << p->x << ", " << p->z;
    ++held;
  }
  EXPECT_GT(held, 300);
}

TEST(ScreenUnoccluded, NoLightIsNoError) {
  Scene scene = scene_seen_from({0, 1, 1}, {0, 0, 0});
  add_floor(scene, 1);
  const Rendering r = rendered(scene, kShot, {.mode = Mode::screen_unoccluded, .spp = 0});
  EXPECT_TRUE(r.complete);
  EXPECT_EQ(brightest(r), 0.0f);
}

}  // namespace
}  // namespace lueur::reference
