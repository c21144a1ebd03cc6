// SPDX-License-Identifier: MIT
#include "surfels/sampling.h"

#include <gtest/gtest.h>

namespace lueur {
namespace {

double area_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

TEST(SurfelSampling, PartsTileATriangle) {
  const glm::dmat3 t({0, 0, 0}, {4, 0.5, 1}, {1, 3, -2});
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  for (const uint32_t parts : {1u, 2u, 8u, 64u}) {
    double sum = 0;
    for (uint32_t k = 0; k < parts * parts; ++k) {
      const glm::dmat3 part = t * glm::dmat3(corners_of_part(parts, k));
      const glm::dvec3 across = glm::cross(part[1] - part[0], part[2] - part[0]);
      EXPECT_GT(glm::dot(across, normal), 0) << k;  // turned as the whole
      EXPECT_NEAR(0.5 * glm::length(across) * parts * parts / area_of(t[0], t[1], t[2]), 1, 1e-4);
      sum += 0.5 * glm::length(across);
      for (int i = 0; i < 3; ++i) {
        const glm::vec3 corner = corners_of_part(parts, k)[i];
        EXPECT_NEAR(corner.x + corner.y + corner.z, 1, 1e-5);
        for (int c = 0; c < 3; ++c) EXPECT_GE(corner[c], -1e-5) << k;
      }
    }
    EXPECT_NEAR(sum / area_of(t[0], t[1], t[2]), 1, 1e-4);
  }
}

TEST(SurfelSampling, PlacesAreEven) {
  // Shares of a triangle's four parts, as each has a quarter of the area.
  int count[4] = {};
  constexpr uint32_t kCount = 4000;
  for (uint32_t i = 0; i < kCount; ++i) {
    const glm::vec3 u = sample_of(7, i);
    const glm::vec3 w = barycentric_of({u.x, u.y});
    EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-5);
    ++count[w.x > 0.5f ? 0 : w.y > 0.5f ? 1 : w.z > 0.5f ? 2 : 3];
  }
  for (const int n : count) EXPECT_NEAR(n, kCount / 4, 25);
}

// As many are kept as there should be, whatever the triangle's start.
TEST(SurfelSampling, TheKeptShareIsTheWanted) {
  int kept = 0;
  for (uint32_t triangle = 0; triangle < 20'000; ++triangle)
    kept += sample_of(pcg(triangle), 0).z < 0.1f;
  EXPECT_NEAR(kept, 2000, 130);  // three standard deviations
}

TEST(SurfelSampling, PartsArePowersOfTwo) {
  EXPECT_EQ(parts_of(1.0f, 2.0f), 1u);
  EXPECT_EQ(parts_of(1.1f, 2.0f), 2u);
  EXPECT_EQ(parts_of(9.0f, 2.0f), 16u);
  EXPECT_EQ(parts_of(1e6f, 0.1f), kMostParts);
}

}  // namespace
}  // namespace lueur
