// SPDX-License-Identifier: MIT
#include "lights/light_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "lights/light_views.h"
#include "shading/halton.h"

namespace lueur {
namespace {

constexpr double kPi = std::numbers::pi;
const Box kBounds{{-3, 0, -2}, {3, 4, 2}};

PunctualLight spot(float outer_cone_rad, const glm::vec3& direction) {
  const glm::vec3 d = glm::normalize(direction);
  return {.kind = PunctualLight::Kind::spot,
          .position = {0, 3, 0},
          .direction = {d.x, d.y, d.z},
          .intensity = {10, 10, 10},
          .outer_cone_rad = outer_cone_rad};
}
const PunctualLight kPoint{.position = {1, 2, 0}, .intensity = {10, 10, 10}};
const PunctualLight kSun{.kind = PunctualLight::Kind::directional,
                         .direction = {0.6f, -0.8f, 0},
                         .intensity = {10, 10, 10}};

double solid_angle(const std::vector<LightRay>& rays) {
  double sum = 0;
  for (const LightRay& ray : rays) sum += ray.solid_angle_sr;
  return sum;
}

TEST(Halton, DigitsAreMirroredAtThePoint) {
  EXPECT_EQ(radical_inverse(2, 0), 0.0f);
  EXPECT_EQ(radical_inverse(2, 6), 0.375f);                     // 110 -> 0.011
  EXPECT_FLOAT_EQ(radical_inverse(3, 5), 2 / 3.0f + 1 / 9.0f);  // 12 -> 0.21
}

TEST(LightRays, RaysShareOutTheConeEvenly) {
  for (const float angle : {0.05f, 0.4f, 1.0f, 2.5f}) {
    const PunctualLight light = spot(angle, {0.3f, -1, 0.2f});
    const glm::vec3 axis(light.direction[0], light.direction[1], light.direction[2]);
    const std::vector<LightRay> rays = rays_of_light(light, kBounds, 300);
    ASSERT_EQ(rays.size(), 300u);
    const double full = 2 * kPi * (1 - std::cos(double{angle}));
    EXPECT_NEAR(solid_angle(rays) / full, 1, 1e-5);
    uint32_t inner = 0;
    for (const LightRay& ray : rays) {
      EXPECT_NEAR(glm::length(ray.direction), 1, 1e-5);
      EXPECT_GE(glm::dot(ray.direction, axis), std::cos(angle) - 1e-5f);
      // Half of the solid angle.
      inner += glm::dot(ray.direction, axis) > 0.5f * (1 + std::cos(angle));
    }
    // Of random ones, 9 more or less would be usual.
    EXPECT_NEAR(inner, 150, 9) << angle;
  }
}

// A sequence's mean of a function is nearer than that of random rays.
TEST(LightRays, HaltonIsMoreEvenThanRandom) {
  const auto error = [](uint32_t count, uint32_t seed) {
    double sum = 0;
    for (const LightRay& ray : rays_of_light(kPoint, kBounds, count, seed))
      sum += std::max(ray.direction.z, 0.0f) * double{ray.solid_angle_sr};
    return std::abs(sum / kPi - 1);
  };
  for (const uint32_t count : {200u, 300u, 1000u, 3000u}) {
    double random = 0;
    for (uint32_t seed = 1; seed <= 20; ++seed) random += error(count, seed) / 20;
    EXPECT_LT(error(count, 0), 0.5 * random) << count;
  }
}

// What stays in a spot's cone stays where it is in the world.
TEST(LightRays, RaysOfATurningSpotStay) {
  const std::vector<LightRay> before = rays_of_light(spot(0.5f, {0, -1, 0}), kBounds, 200);
  const std::vector<LightRay> after = rays_of_light(spot(0.5f, {0.1f, -1, 0}), kBounds, 200);
  size_t same = 0;
  for (const LightRay& a : after)
    for (const LightRay& b : before) same += a.direction == b.direction;
  EXPECT_GT(same, 150u);
  EXPECT_LT(same, 200u);
}

TEST(LightRays, ASunCoversWhatThereIs) {
  const std::vector<LightRay> rays = rays_of_light(kSun, kBounds, 500);
  ASSERT_EQ(rays.size(), 500u);
  const View view = views_of_light(kSun, kBounds).front();
  std::vector<bool> taken(rays.size());
  EXPECT_EQ(rays_in_view(rays, view, 64, taken).size(), 500u);
  // From the box's sides: 4 m x 4 m x 0.6 of one and 6 m x 4 m x 0.8 of the other face the sun. Its
  // view stands off by 50 radii.
  const double distance_m = 50 * 0.5 * std::sqrt(36.0 + 16 + 16);
  EXPECT_NEAR(solid_angle(rays) * distance_m * distance_m / (16 * 0.6 + 24 * 0.8), 1, 0.02);
}

TEST(LightRays, EachRayIsInOneView) {
  for (const PunctualLight& light :
       {kPoint, spot(0.4f, {1, -1, 0}), spot(1.4f, {1, -1, 0}), kSun}) {
    const std::vector<LightRay> rays = rays_of_light(light, kBounds, 300);
    std::vector<bool> taken(rays.size());
    size_t seen = 0;
    for (const View& view : views_of_light(light, kBounds))
      for (const SeenLightRay& ray : rays_in_view(rays, view, 128, taken)) {
        ++seen;
        EXPECT_GE(std::min(ray.at_px.x, ray.at_px.y), 0.0f);
        EXPECT_LE(std::max(ray.at_px.x, ray.at_px.y), 128.0f);
      }
    EXPECT_EQ(seen, rays.size());
  }
}

TEST(LightRays, LightsGetTheirShareOfTheRays) {
  PunctualLight dim = kPoint, dark = kPoint;
  dim.intensity = {0.01f, 0.01f, 0.01f};
  dark.intensity = {};
  const std::array lights = {kPoint, dim, dark, kPoint};
  const std::vector<uint32_t> shares = shares_of_lights(lights, kBounds, 101);
  EXPECT_EQ(shares, (std::vector<uint32_t>{50, 1, 0, 50}));
  EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), 0u), 101u);
  EXPECT_EQ(shares_of_lights(lights, kBounds, 1), (std::vector<uint32_t>{0, 1, 0, 0}));
  EXPECT_TRUE(shares_of_lights({}, kBounds, 10).empty());
}

}  // namespace
}  // namespace lueur
