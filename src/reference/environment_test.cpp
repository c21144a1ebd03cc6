// SPDX-License-Identifier: MIT
// Light of environments that is known in closed form, and what the camera sees of them.
#include <cmath>
#include <set>

#include "reference/content.h"
#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::reference {
namespace {

Environment uniform(float radiance) {
  return {.width = 8, .height = 4, .rgb = std::vector<float>(8 * 4 * 3, radiance)};
}

// The closed form where a surface is seen, nothing elsewhere.
std::function<std::optional<double>(size_t)> on_surfaces(const Scene& scene, double exact) {
  const Rendering seen = rendered(scene, kShot, {.mode = Mode::ambient, .spp = 8});
  const ImageF depth = layer(seen, "depth");
  return [=](size_t i) -> std::optional<double> {
    return depth.samples[i] > 0.0f ? std::optional(exact) : std::nullopt;
  };
}

// All that a convex thing sees is the environment, however many bounces there may be.
TEST(EnvironmentLight, UniformOneAroundABox) {
  Scene scene = scene_seen_from({1.5f, 1.2f, 2.2f}, {0, 0, 0});
  builtin::MeshBuilder builder;
  builtin::add_box(builder, glm::vec3(-0.7f), glm::vec3(0.7f), {.edge_m = 2.0f});
  builtin::add_mesh(scene, builder.finish("box"));
  scene.materials[0].specular = 0.0f;
  scene.environment = uniform(2.0f);
  scene.environment->intensity = 1.5f;
  expect_unbiased(estimates(scene, kShot, {.bounces = 3, .spp = 16}, kSeedCount),
                  on_surfaces(scene, 3.0));
}

// A floor of glossy metal under it and one within a glowing sphere get the same light.
TEST(EnvironmentLight, UniformOneEqualsAGlowingRoom) {
  const auto floor_scene = [] {
    Scene scene = scene_seen_from({0, 0.3f, 0.6f}, {0, 0, 0});
    scene.materials[0].metallic = 1.0f;
    scene.materials[0].roughness = 0.4f;
    add_floor(scene, 0.2f);
    return scene;
  };
  Scene open = floor_scene(), room = floor_scene();
  open.environment = uniform(2.0f);
  builtin::MeshBuilder builder;
  builtin::add_sphere(builder, glm::vec3(0.0f), 3.0f, 32);
  builtin::add_mesh(room, builder.finish("shell"));
  const int32_t glow = add_diffuse(room, 0, 2);
  room.meshes.back().primitives[0].material = glow;
  const auto in_open =
      estimates_of_both(open, kShot, {.spp = 16}, kSeedCount, "indirect_specular", "depth");
  Estimates in_room =
      estimates(room, kShot, {.spp = 16, .seed = 1000}, kSeedCount, "indirect_specular");
  Estimates kept_open{kSeedCount, {}, {}}, kept_room{kSeedCount, {}, {}};
  for (size_t i = 0; i < in_room.mean.size(); ++i) {
    if (!(in_open.second.mean[i] > 0.0)) continue;  // beside the floor
    kept_open.mean.push_back(in_open.first.mean[i]);
    kept_open.error.push_back(in_open.first.error[i]);
    kept_room.mean.push_back(in_room.mean[i]);
    kept_room.error.push_back(in_room.error[i]);
  }
  ASSERT_GT(kept_open.mean.size(), 50u);
  expect_same(kept_open, kept_room);
}

// One pixel of a picture of 8 x 4, at column 5 and row 1: large enough for directions of the BRDF
// to find it often, as rare finds do not scatter as expect_unbiased() takes it.
constexpr double kSunRadiance = 500.0;
Environment one_pixel_sun() {
  Environment sun{.width = 8, .height = 4, .rgb = std::vector<float>(8 * 4 * 3, 0.0f)};
  for (size_t c = 0; c < 3; ++c) sun.rgb[(1 * 8 + 5) * 3 + c] = static_cast<float>(kSunRadiance);
  return sun;
}
constexpr double kTop = kPi / 4, kBottom = kPi / 2;                            // from +y
constexpr double kLeft = 2 * kPi * (5.0 / 8 - 0.5), kRight = kLeft + kPi / 4;  // from -z to +x

TEST(EnvironmentLight, OnePixelSunOverAFloor) {
  Scene scene = scene_seen_from({0, 1, 2}, {0, 0, 0});
  scene.materials[0].specular = 0.0f;
  add_floor(scene, 1);
  scene.environment = one_pixel_sun();
  // The integral of cos over the pixel's solid angle, sin dtheta dphi.
  const double squares = std::pow(std::cos(kTop), 2) - std::pow(std::cos(kBottom), 2);
  const double exact = kSunRadiance * (kRight - kLeft) * 0.5 * squares / kPi;
  expect_unbiased(estimates(scene, kShot, {.spp = 16}, kSeedCount), on_surfaces(scene, exact));
}

// On a wall that faces +x; the direction of angle phi has the x of sin(theta) sin(phi), and turned
// by r counter-clockwise that of sin(theta) sin(phi - r).
TEST(EnvironmentLight, OnePixelSunTurned) {
  constexpr double kTurn = 0.25;
  Scene scene = scene_seen_from({2, 0.3f, 0.5f}, {0, 0, 0});
  scene.materials[0].specular = 0.0f;
  add_quad(scene, {0, -0.5f, 0.5f}, {0, 0, -1}, {0, 1, 0});
  scene.environment = one_pixel_sun();
  scene.environment->rotation_rad = static_cast<float>(kTurn);
  const auto integral_of_sin2 = [](double a) { return 0.5 * a - 0.25 * std::sin(2 * a); };
  const double exact = kSunRadiance / kPi * (integral_of_sin2(kBottom) - integral_of_sin2(kTop)) *
                       (std::cos(kLeft - kTurn) - std::cos(kRight - kTurn));
  expect_unbiased(estimates(scene, kShot, {.spp = 16}, kSeedCount), on_surfaces(scene, exact));
}

TEST(EnvironmentLight, OnlyPathTakesIt) {
  Scene scene = scene_seen_from({0, 1, 2}, {0, 0, 0});
  add_floor(scene, 1);
  scene.environment = uniform(1.0f);
  for (const Mode mode : {Mode::screen, Mode::screen_unoccluded})
    for (const float sample :
         layer(rendered(scene, kShot, {.mode = mode, .spp = 16}), "indirect").samples)
      ASSERT_EQ(sample, 0.0f);
  // What is behind everything is in the picture, and not in direct light.
  const Rendering path = rendered(scene, kShot, {.spp = 16});
  EXPECT_EQ(layer(path, "").at(0, 0, 0), 1.0f);
  EXPECT_EQ(layer(path, "direct").at(0, 0, 0), 0.0f);
}

TEST(EnvironmentLight, TheCameraSeesItWhereItIs) {
  // Red tells u and green v, at the middles of pixels; between them both are interpolated.
  Scene scene = scene_seen_from({0, 0, 0}, {0.2f, 0.3f, -1});
  Environment picture{.width = 512, .height = 256};
  for (uint32_t y = 0; y < 256; ++y)
    for (uint32_t x = 0; x < 512; ++x)
      for (const float value :
           {(static_cast<float>(x) + 0.5f) / 512, (static_cast<float>(y) + 0.5f) / 256, 0.0f})
        picture.rgb.push_back(value);
  for (const double turn : {0.0, 0.5}) {
    scene.environment = picture;
    scene.environment->rotation_rad = static_cast<float>(turn);
    const ImageF seen = layer(rendered(scene, kShot, {.spp = 1}), "");
    for (const PixelRay& ray : rays_of(scene, kShot)) {
      const glm::dvec3 d = glm::normalize(ray.direction);
      const double u = 0.5 + (std::atan2(d.x, -d.z) + turn) / (2 * kPi);
      ASSERT_NEAR(seen.at(ray.x, ray.y, 0), u, 1e-5);
      ASSERT_NEAR(seen.at(ray.x, ray.y, 1), std::acos(d.y) / kPi, 1e-5);
    }
  }
}

TEST(EnvironmentLight, NamesOfRenderingsDependOnIt) {
  Scene scene = scene_seen_from({0, 1, 2}, {0, 0, 0});
  const std::string without = content_key(scene, kShot, {});
  scene.environment = uniform(1.0f);
  const std::string with = content_key(scene, kShot, {});
  scene.environment->rotation_rad = 1.0f;
  const std::string turned = content_key(scene, kShot, {});
  scene.environment->rgb[5] = 2.0f;
  const std::string painted = content_key(scene, kShot, {});
  EXPECT_EQ((std::set{without, with, turned, painted}).size(), 4u);
}

}  // namespace
}  // namespace lueur::reference
