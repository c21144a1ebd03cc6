// SPDX-License-Identifier: MIT
// What glossy lobes reflect of a map.
#include "techniques/cube_map/cube_map_fixture.h"

namespace lueur {
namespace {

// LCM 5's lobe, with all that a point reflects; a map of 16 x 16 texels is enough to tell signs.
TEST_F(CubeMapTest, BlinnsLobeIsSummedTheSameWay) {
  settings_.glossy = true;
  settings_.blinn_exponent = 5.0f;
  settings_.side = Settings::Side::of_16;
  settings_.probes = 0;
  BallHost host(room, {{{-0.3, -0.5, -0.5}, 1.2}});
  render(host);
  const auto map = exact_map(host.without(std::vector{0u}), host.balls()[0].centre, side());
  const double c = 7 * 9 / (8 * kPi * (std::pow(2, -2.5) + 5));
  const Light found = all("specular");
  for (size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 x = position(i), n = normal(i);
    if (g_.depth[i] == 0 || !host.ball_at(x)) {
      ASSERT_EQ(found[i], glm::dvec3(0)) << i;
      continue;
    }
    const glm::dvec3 to_eye = glm::normalize(eye_ - x);
    const glm::dvec3 want =
        glm::dvec3(0.5, 0.25, 1.0) * exact_sum(map, x, true, [&](const glm::dvec3& l) {
          const double half = std::max(glm::dot(n, glm::normalize(l + to_eye)), 0.0);
          return c * std::pow(half, 5) * std::max(glm::dot(n, l), 0.0);
        });
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 2e-3 * want[k] + 2e-5) << i;
  }
}

// The surfaces' own lobe, as wide as the texel makes it: FDP's and LCM's lobes are looked at once.
TEST_F(CubeMapTest, CosineLobesAreSummedAsWideAsTexels) {
  settings_.glossy = true;
  settings_.probes = 0;
  BallHost host(room, {{{-0.3, -0.5, -0.5}, 1.2}});
  render(host);
  const auto map = exact_map(host.without(std::vector{0u}), host.balls()[0].centre, side());
  const Light found = all("specular");
  for (size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 x = position(i), n = normal(i);
    if (g_.depth[i] == 0 || !host.ball_at(x)) continue;
    const glm::dvec3 mirrored = glm::reflect(glm::normalize(x - eye_), n);
    const auto phong = [&](const glm::dvec3& l, double solid_angle) {
      const double exponent = 1 / (1 / double{kLobe.exponent} + 0.5 * solid_angle / kPi);
      return (exponent + 2) / (2 * kPi) * std::pow(std::max(glm::dot(mirrored, l), 0.0), exponent) *
             std::max(glm::dot(n, l), 0.0);
    };
    const glm::dvec3 want = glm::dvec3(0.5, 0.25, 1.0) * exact_sum(map, x, true, phong);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 2e-3 * want[k] + 2e-4) << i;
  }
}

// A lobe that reflects all of radiance 1 gives its colour.
TEST_F(CubeMapTest, ClassicalGlossKeepsAFurnacesRadiance) {
  settings_.method = Settings::Method::classical;
  settings_.glossy = true;
  settings_.probes = 0;
  BallHost host(furnace, {{{0.3, 0.2, 0}, 1.0}});
  render(host);
  const Light found = all("specular");
  for (size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 want = host.ball_at(position(i)) ? glm::dvec3(0.5, 0.25, 1.0) : glm::dvec3(0);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 2e-3) << i;
  }
}

}  // namespace
}  // namespace lueur
