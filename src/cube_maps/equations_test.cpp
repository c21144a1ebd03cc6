// SPDX-License-Identifier: MIT
#include "cube_maps/equations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cube_maps/blinn.h"

namespace lueur {
namespace {

constexpr double kPi = std::numbers::pi;

double sum_over_cube(int side, double (*exact)(int side, int x, int y)) {
  double sum = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) sum += exact(side, x, y);
  return 6 * sum;
}

double by_formula(int side, int x, int y) {
  const double u = (2 * x + 1.0) / side - 1, v = (2 * y + 1.0) / side - 1;
  return texel_solid_angle(float(side), float(std::sqrt(u * u + v * v + 1)));
}

// The solid angle of the rectangle from a face's middle to (u, v).
double corner_angle(double u, double v) {
  return std::atan(u * v / std::sqrt(u * u + v * v + 1));
}

double exactly(int side, int x, int y) {
  const double u0 = 2.0 * x / side - 1, u1 = 2.0 * (x + 1) / side - 1;
  const double v0 = 2.0 * y / side - 1, v1 = 2.0 * (y + 1) / side - 1;
  return corner_angle(u1, v1) - corner_angle(u0, v1) - corner_angle(u1, v0) + corner_angle(u0, v0);
}

// What the header says of it.
TEST(CubeMapEquations, SolidAnglesSumToTheSphere) {
  EXPECT_NEAR(sum_over_cube(4, exactly), 4 * kPi, 1e-9);
  const std::pair<int, double> missing[] = {{2, 0.114}, {4, 0.031}, {8, 0.008}, {16, 0.002}};
  for (const auto& [side, share] : missing)
    EXPECT_NEAR(sum_over_cube(side, by_formula) / (4 * kPi), 1 - share, 5e-4) << side;
  EXPECT_NEAR(sum_over_cube(256, by_formula) / (4 * kPi), 1, 2e-4);
  // Each texel by itself, where texels are small.
  for (int x = 0; x < 64; ++x) EXPECT_NEAR(by_formula(64, x, 5) / exactly(64, x, 5), 1, 1e-3) << x;
}

TexelLight light_at(const glm::vec3& position, float distance, float solid_angle_sr) {
  const float over_pi = solid_angle_sr / float(kPi);
  return {position, distance * distance * over_pi, glm::vec3(1), 1 - over_pi};
}

TEST(CubeMapEquations, FromTheCentreASolidAngleIsTheTexels) {
  for (const float d : {0.1f, 1.0f, 50.0f})
    for (const float w : {0.001f, 0.1f, 0.46f})
      EXPECT_NEAR(localized_share(light_at({0, 0, -d}, d, w), d * d) * kPi, w, 1e-6 * w);
}

// A disc of this size, facing the point, as LCM's form factor has it: A / (r^2 + A / pi).
TEST(CubeMapEquations, FromElsewhereItIsThatOfTheSameSurface) {
  const double d = 3, w = 0.3;
  const double area = d * d * w / (1 - w / kPi);
  for (const double r : {0.0, 0.5, 3.0, 20.0})
    EXPECT_NEAR(localized_share(light_at({0, 0, -3}, float(d), float(w)), float(r * r)) * kPi,
                area / (r * r + area / kPi), 1e-5);
}

// Light from everywhere and along the normal.
TEST(CubeMapEquations, BlinnsLobeReflectsAllAlongTheNormal) {
  for (const float exponent : {1.0f, 5.0f, 40.0f}) {
    double sum = 0;
    constexpr int kSteps = 20'000;
    for (int i = 0; i < kSteps; ++i) {
      const double theta = 0.5 * kPi * (i + 0.5) / kSteps;
      const glm::vec3 l(std::sin(theta), 0, std::cos(theta));
      sum += blinn_brdf(exponent, {0, 0, 1}, l, {0, 0, 1}) * std::cos(theta) * std::sin(theta) * 2 *
             kPi * 0.5 * kPi / kSteps;
    }
    EXPECT_NEAR(sum, 1, 2e-3) << exponent;
  }
}

}  // namespace
}  // namespace lueur
