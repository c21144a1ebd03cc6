// SPDX-License-Identifier: MIT
// Ambient occlusion against closed forms.
#include <cmath>

#include "reference/reference_fixture.h"

namespace lueur::reference {
namespace {

Settings ambient(float distance_m, uint32_t spp = 16) {
  return {.mode = Mode::ambient, .spp = spp, .ambient_distance_m = distance_m};
}

TEST(Ambient, NothingAroundIsOpen) {
  Scene scene = scene_seen_from({0, 1, 2}, {0, 0, 0});
  add_floor(scene, 50);
  const Rendering r = rendered(scene, kShot, ambient(1000));
  const ImageF &occlusion = layer(r, "occlusion"), &depth = layer(r, "depth");
  EXPECT_EQ(occlusion.channels, 1u);
  for (size_t i = 0; i < occlusion.samples.size(); ++i)
    EXPECT_EQ(occlusion.samples[i], depth.samples[i] > 0 ? 1.0f : 0.0f);
  EXPECT_EQ(find_layer(r, "indirect"), nullptr);
  EXPECT_EQ(find_layer(r, ""), nullptr);
}

Scene wall_scene(float half_width, float height) {
  Scene scene = scene_seen_from({0, 0.8f, 2}, {0, 0, 0.3f});
  add_floor(scene, 5);
  add_quad(scene, {-half_width, 0, 0}, {2 * half_width, 0, 0}, {0, height, 0});
  return scene;
}

std::optional<glm::dvec3> on_floor(const PixelRay& ray) {
  const auto p = meet_plane(ray, {}, {0, 1, 0});
  return p && p->z > 0 && p->z < 1.9 ? p : std::nullopt;
}

// All of a wall within reach: what it covers of the sky is its polygon's share.
TEST(Ambient, FreeOfAWallInReach) {
  const Scene scene = wall_scene(1.5f, 2);
  const auto rays = rays_of(scene, kShot);
  const auto wall = quad_corners({-1.5, 0, 0}, {3, 0, 0}, {0, 2, 0});
  expect_unbiased(estimates(scene, kShot, ambient(100), kSeedCount, "occlusion"),
                  [&](size_t i) -> std::optional<double> {
                    const auto p = on_floor(rays[i]);
                    if (!p) return std::nullopt;
                    return 1.0 - polygon_share(*p, {0, 1, 0}, wall);
                  });
}

// At the foot of a tall wall half of the sky is left.
TEST(Ambient, HalfAtTheFootOfAWall) {
  Scene scene = wall_scene(1000, 1000);
  scene.nodes[0].translation = {0, 0.02f, 0.05f};
  scene.cameras[0].near_m = 1e-3f;
  const Rendering r = rendered(scene, {8, 8}, ambient(1e5f, 4096));
  const auto rays = rays_of(scene, {8, 8});
  int held = 0;
  for (const PixelRay& ray : rays) {
    const auto p = meet_plane(ray, {}, {0, 1, 0});
    if (!p || !(p->z > 0) || p->z > 0.04) continue;
    // 4096 stratified samples are closer than as many random ones: 0.5 / 64, three times.
    EXPECT_NEAR(layer(r, "occlusion").samples[ray.index], 0.5, 0.024);
    ++held;
  }
  EXPECT_GT(held, 4);
}

// Of an endless wall at distance d a ray of length R meets, from a point on the floor, a half disc
// around the wall's nearest point, of radius sqrt(R^2 - d^2). Lambert's sum over its outline: the
// diameter is seen under 2 acos(d / R); along the arc, at distance R, the integral of the floor
// component of p x dp / R^2 is -2 d sqrt(R^2 - d^2) / R^2. With q = d / R the half disc covers
//   (acos q - q sqrt(1 - q^2)) / pi,
// 1/2 at q = 0 and 0 at q = 1.
TEST(Ambient, EndsAtItsDistance) {
  constexpr double kReach = 0.9;
  const Scene scene = wall_scene(5, 5);
  const auto rays = rays_of(scene, kShot);
  expect_unbiased(
      estimates(scene, kShot, ambient(static_cast<float>(kReach)), kSeedCount, "occlusion"),
      [&](size_t i) -> std::optional<double> {
        const auto p = on_floor(rays[i]);
        if (!p) return std::nullopt;
        const double q = p->z / kReach;
        if (q >= 1) return 1.0;
        return 1.0 - (std::acos(q) - q * std::sqrt(1 - q * q)) / kPi;
      });
}

TEST(Ambient, InsideABox) {
  const Scene scene = inside_box();
  const ImageF dark = layer(rendered(scene, kShot, ambient(10)), "occlusion");
  for (const float v : dark.samples) EXPECT_EQ(v, 0.0f);

  const Rendering open = rendered(scene, kShot, ambient(0.1f));
  const ImageF &occlusion = layer(open, "occlusion"), &depth = layer(open, "depth");
  int held = 0;
  for (const PixelRay& ray : rays_of(scene, kShot)) {
    const glm::dvec3 p =
        glm::abs(ray.origin + static_cast<double>(depth.samples[ray.index]) * ray.direction);
    // On one wall, further than 0.1 m from the others.
    const int near = (p.x > 0.89) + (p.y > 0.89) + (p.z > 0.89);
    if (near != 1) continue;
    EXPECT_EQ(occlusion.samples[ray.index], 1.0f);
    ++held;
  }
  EXPECT_GT(held, 300);
}

}  // namespace
}  // namespace lueur::reference
