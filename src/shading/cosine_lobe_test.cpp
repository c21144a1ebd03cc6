// SPDX-License-Identifier: MIT
#include "shading/cosine_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lueur {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr vec3 kUp{0, 0, 1};

vec3 direction(float polar_rad, float azimuth_rad) {
  return {std::sin(polar_rad) * std::cos(azimuth_rad), std::sin(polar_rad) * std::sin(azimuth_rad),
          std::cos(polar_rad)};
}

// The formula of lueur/g_buffer.h, in the surface's frame and in double precision.
double lobe_by_coordinates(double n, double c_xy, double c_z, const glm::dvec3& l,
                           const glm::dvec3& v) {
  const double m = std::max(std::abs(c_xy), std::abs(c_z));
  const double c = c_xy * (l.x * v.x + l.y * v.y) + c_z * l.z * v.z;
  return (n + 2) / (2 * kPi * std::pow(m, n)) * std::pow(std::max(c, 0.0), n);
}

TEST(CosineLobe, IsTheFormulaByCoordinates) {
  int bright = 0;
  for (const float exponent : {1.0f, 6.0f, 40.0f}) {
    for (const vec2 c : {vec2(-1, 1), vec2(-1, 0.5f), vec2(-0.4f, 0.9f), vec2(2, 1), vec2(0, 1)}) {
      for (int i = 0; i < 60; ++i) {
        const auto step = static_cast<float>(i);
        const vec3 l = direction(0.025f * step, 1.7f * step), v = direction(0.7f, 0.4f);
        const double exact = lobe_by_coordinates(exponent, c.x, c.y, l, v);
        // Rounding of the cosine, 4e-7 of the largest, n times; where it is small against that, the
        // lobe is, too.
        ASSERT_NEAR(cosine_lobe(exponent, c.x, c.y, kUp, l, v), exact,
                    2e-6 * exponent * (exact + 0.01))
            << exponent << ", " << c.x << ", " << c.y << ", " << i;
        bright += exact > 0.1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(bright, 100);
}

TEST(CosineLobe, VanishesWithItsCoefficientsAndBehindItsAxis) {
  for (const float exponent : {0.0f, 0.5f, 8.0f, 1e5f}) {
    EXPECT_EQ(cosine_lobe(exponent, 0, 0, kUp, direction(0.3f, 1), direction(0.3f, 2)), 0.0f);
    // Nothing of the light lies along the mirrored eye, exactly and by far.
    EXPECT_EQ(cosine_lobe(exponent, -1, 0, kUp, kUp, direction(0.3f, 2)), 0.0f);
    EXPECT_EQ(cosine_lobe(exponent, -1, 1, kUp, direction(1.5f, 2), direction(1.5f, 2)), 0.0f);
  }
  // With an exponent of 0 all that it sees is alike.
  EXPECT_NEAR(cosine_lobe(0, -1, 1, kUp, direction(0.5f, 1), direction(0.6f, 2)), 1 / kPi, 1e-6);
}

TEST(CosineLobe, AxisIsUnitAndTheNormalWhereThereIsNone) {
  const vec3 eye = direction(0.8f, 0.3f);
  for (const vec2 c : {vec2(-1, 1), vec2(-1, 0.5f), vec2(3, 2), vec2(-1, 0)}) {
    const vec3 axis = cosine_lobe_axis(c.x, c.y, kUp, eye);
    const glm::dvec3 exact = glm::normalize(glm::dvec3(c.x, c.x, c.y) * glm::dvec3(eye));
    EXPECT_LT(glm::length(glm::dvec3(axis) - exact), 1e-6) << c.x << ", " << c.y;
  }
  EXPECT_EQ(cosine_lobe_axis(0, 0, kUp, eye), kUp);
  EXPECT_EQ(cosine_lobe_axis(-1, 0, kUp, kUp), kUp);
}

}  // namespace
}  // namespace lueur
