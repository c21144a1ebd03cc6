// SPDX-License-Identifier: MIT
// Direct light against closed forms: KHR_lights_punctual on surfaces that nothing shades.
#include <cmath>

#include "image/tone_map.h"
#include "renderer/renderer_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur {
namespace {

constexpr glm::dvec3 kUp{0, 1, 0};

class LightTest : public RendererTest {
 protected:
  // Compares the source radiance of each pixel that sees the floor with `expected(point)`.
  void expect_floor(const std::function<double(const glm::dvec3&)>& expected, double half_side,
                    double absolute = 0.0) {
    int compared = 0;
    for (const PixelRay& ray : rays()) {
      const auto p = meet_plane(ray, {}, kUp);
      if (!p || std::abs(p->x) > half_side || std::abs(p->z) > half_side) continue;
      const double exact = expected(*p);
      ASSERT_NEAR(static_cast<double>(luminance_at("source", ray)), exact,
                  kHalfError * exact + absolute)
          << "at " << p->x << ", " << p->z;
      ++compared;
    }
    EXPECT_GT(compared, 1000);
  }
};

TEST_F(LightTest, PointLightFallsOffWithDistanceAndCosine) {
  constexpr double kCandela = 50.0, kHeight = 1.5;
  Scene scene = scene_seen_from({0.3f, 4, 0.2f}, {0.3f, 0, 0});
  add_floor(scene, 2);
  const glm::dvec3 light(0.5, kHeight, -0.25);
  add_light(scene, LightKind::point, kCandela, light);
  render(scene);
  // I cos(theta) / (pi r^2) with cos(theta) = h / r; I / (pi h^2) right below.
  expect_floor(
      [&](const glm::dvec3& p) {
        const double r = glm::length(light - p);
        return kCandela * kHeight / (kPi * r * r * r);
      },
      1.9);
}

TEST_F(LightTest, LightEndsAtItsRange) {
  constexpr double kCandela = 50.0, kHeight = 1.0, kRange = 2.0;
  Scene scene = scene_seen_from({0.3f, 4, 0.2f}, {0.3f, 0, 0});
  add_floor(scene, 2);
  const glm::dvec3 light(0, kHeight, 0);
  add_light(scene, LightKind::point, kCandela, light).range_m = kRange;
  render(scene);
  int dark = 0;
  expect_floor(
      [&](const glm::dvec3& p) {
        const double r = glm::length(light - p);
        dark += r >= kRange;
        const double window = std::max(1.0 - std::pow(r / kRange, 4.0), 0.0);
        return window * kCandela * kHeight / (kPi * r * r * r);
      },
      // Where the window ends, the smallest half float is coarser than the light.
      1.9, 1e-4);
  EXPECT_GT(dark, 100);
}

TEST_F(LightTest, RadianceRightBelowIsAlbedoTimesIntensityOverPiHeightSquared) {
  for (const double height : {0.5, 2.0, 20.0}) {
    Scene scene = scene_seen_from({0, 3, 0}, {0, 0, 0});
    const auto candela = static_cast<float>(100.0 * height * height);
    const int32_t grey = builtin::add_material(scene, "grey", glm::vec3(0.5f, 0.25f, 0.1f), 1.0f);
    add_floor(scene, 2, grey);
    // Off the camera's path, as if it were not there.
    add_light(scene, LightKind::point, candela, {0, static_cast<float>(height), 0}).color = {
        1.0f, 0.5f, 2.0f};
    render(scene, {.extent = {33, 33}});
    const PixelRay middle = rays()[16 * 33 + 16];
    const glm::vec4 source = at("source", middle), albedo = at("albedo", middle);
    for (int c = 0; c < 3; ++c) {
      const double exact = static_cast<double>(albedo[c] * scene.lights[0].color[c]) * 100.0 / kPi;
      EXPECT_NEAR(static_cast<double>(source[c]), exact, kHalfError * exact) << c;
      // The base colour is kept in 8 bits of sRGB.
      EXPECT_NEAR(srgb_from_linear(albedo[c]), srgb_from_linear(scene.materials[1].base_color[c]),
                  0.75f / 255.0f);
    }
  }
}

double spot_attenuation(double cos_angle, double inner, double outer) {
  const double scale = 1.0 / std::max(0.001, std::cos(inner) - std::cos(outer));
  const double linear = std::clamp((cos_angle - std::cos(outer)) * scale, 0.0, 1.0);
  return linear * linear;
}

TEST_F(LightTest, SpotConeFollowsTheExtension) {
  constexpr double kCandela = 80.0;
  const glm::dvec3 position(-0.4, 1.6, 0.3), axis = glm::normalize(glm::dvec3(0.3, -1.0, -0.1));
  // Narrow, wide, wider than one flat map, and with a hard edge.
  for (const auto& cone :
       {std::pair(0.1, 0.35), std::pair(0.0, 0.9), std::pair(0.7, 1.3), std::pair(0.4, 0.42)}) {
    const double inner = cone.first, outer = cone.second;
    SCOPED_TRACE(outer);
    Scene scene = scene_seen_from({0.3f, 4, 0.2f}, {0.3f, 0, 0});
    add_floor(scene, 2);
    Light& light = add_light(scene, LightKind::spot, kCandela, position, axis);
    light.inner_cone_rad = static_cast<float>(inner);
    light.outer_cone_rad = static_cast<float>(outer);
    render(scene);
    // At the edge the attenuation is steep in the angle: rounding of position and matrices, 1e-6,
    // is magnified by 2 / (cos(inner) - cos(outer)).
    const double steepness = 2.0 / (std::cos(inner) - std::cos(outer));
    const double peak = kCandela / (kPi * position.y * position.y);
    expect_floor(
        [&](const glm::dvec3& p) {
          const double r = glm::length(position - p);
          const double cos_angle = glm::dot(p - position, axis) / r;
          return spot_attenuation(cos_angle, inner, outer) * kCandela * position.y /
                 (kPi * r * r * r);
        },
        1.9, 1e-6 * steepness * peak);
  }
}

TEST_F(LightTest, DirectionalLightIsLuxTimesCosine) {
  for (const float angle : {0.0f, 0.5f, 1.2f}) {
    Scene scene = scene_seen_from({0, 4, 0.2f}, {0, 0, 0});
    add_floor(scene, 2);
    const glm::vec3 direction(std::sin(angle), -std::cos(angle), 0);
    // Where the node stands does not matter.
    add_light(scene, LightKind::directional, 1000.0f, {70, -3, 5}, direction);
    render(scene);
    expect_floor(
        [&](const glm::dvec3&) { return 1000.0 * std::cos(static_cast<double>(angle)) / kPi; },
        1.9);
  }
}

TEST_F(LightTest, LightsAddUpAndFromBelowThereIsNone) {
  Scene scene = scene_seen_from({0, 4, 0.2f}, {0, 0, 0});
  add_floor(scene, 2);
  add_light(scene, LightKind::directional, 100.0f, {}, {0, -1, 0});
  add_light(scene, LightKind::directional, 50.0f, {}, {0, -1, 0});
  add_light(scene, LightKind::directional, 1e6f, {}, {0, 1, 0.1f});
  add_light(scene, LightKind::point, 1e6f, {0, -1, 0});
  render(scene);
  // Two roundings to half floats.
  expect_floor([](const glm::dvec3&) { return 150.0 / kPi; }, 1.9, kHalfError * 100 / kPi);
}

// A grazing light, and cones that have no inside: nothing may become NaN or infinite, which the
// scan of each pass looks for.
TEST_F(LightTest, ExtremeLightsStayFinite) {
  Scene scene = scene_seen_from({0, 4, 0.2f}, {0, 0, 0});
  add_floor(scene, 2);
  add_light(scene, LightKind::point, 1e30f, {0, 1, 0});
  add_light(scene, LightKind::point, 1.0f, {0, 0, 0});
  add_light(scene, LightKind::directional, 10.0f, {}, {1, 0, 0});
  Light& needle = add_light(scene, LightKind::spot, 10.0f, {0, 1, 0});
  needle.inner_cone_rad = needle.outer_cone_rad = 0.0f;
  Light& half_space = add_light(scene, LightKind::spot, 10.0f, {0, 1, 0});
  half_space.inner_cone_rad = half_space.outer_cone_rad = 1.5707964f;
  render(scene);
  EXPECT_FALSE(HasFailure());
}

TEST_F(LightTest, NoLightGivesBlack) {
  Scene scene = scene_seen_from({0, 4, 0.2f}, {0, 0, 0});
  add_floor(scene, 2);
  add_light(scene, LightKind::point, 0.0f, {0, 1, 0});
  render(scene);
  for (const PixelRay& ray : rays()) {
    ASSERT_EQ(glm::vec3(at("source", ray)), glm::vec3(0.0f));
    ASSERT_EQ(glm::vec3(at("specular", ray)), glm::vec3(0.0f));
  }
}

}  // namespace
}  // namespace lueur
