// SPDX-License-Identifier: MIT
// Triangles of a polygon cover it: their areas, all of one sign, add up to the polygon's own.
#include "scene/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lueur {
namespace {
using glm::vec3;

// The sum of the triangles' areas along the polygon's normal, and the smallest of them.
struct Cover {
  double area = 0.0;
  double smallest = 1e30;
};
Cover cover_of(const std::vector<vec3>& corners, const std::vector<uint32_t>& triangles) {
  const glm::dvec3 normal = glm::normalize(area_vector(corners));
  Cover cover;
  for (size_t i = 0; i < triangles.size(); i += 3) {
    const std::vector<vec3> t = {corners[triangles[i]], corners[triangles[i + 1]],
                                 corners[triangles[i + 2]]};
    const double area = 0.5 * glm::dot(area_vector(t), normal);
    cover.area += area;
    cover.smallest = std::min(cover.smallest, area);
  }
  return cover;
}

void expect_covered(const std::vector<vec3>& corners, double area) {
  std::vector<uint32_t> triangles;
  ASSERT_TRUE(triangulate(corners, triangles));
  const Cover cover = cover_of(corners, triangles);
  EXPECT_NEAR(cover.area, area, 1e-6 * area);
  EXPECT_GE(cover.smallest, 0.0);
}

TEST(Polygon, ConvexAndConcaveOnesAreCovered) {
  expect_covered({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}, 6.0);
  // An arrow: a fan from its first corner would cover what is outside.
  expect_covered({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}}, 4.0);
  // A comb with three teeth, in the x-z plane, seen from below.
  expect_covered({{0, 0, 0},
                  {5, 0, 0},
                  {5, 0, 3},
                  {4, 0, 3},
                  {4, 0, 1},
                  {3, 0, 1},
                  {3, 0, 3},
                  {2, 0, 3},
                  {2, 0, 1},
                  {1, 0, 1},
                  {1, 0, 3},
                  {0, 0, 3}},
                 11.0);
  // Either way round.
  expect_covered({{3, 1, 0}, {4, 4, 0}, {4, 0, 0}, {0, 0, 0}}, 4.0);
}

TEST(Polygon, AHoleJoinedByADoubleEdgeStaysOpen) {
  expect_covered({{0, 0, 0},
                  {3, 0, 0},
                  {3, 3, 0},
                  {0, 3, 0},
                  {0, 0, 0},
                  {1, 1, 0},
                  {1, 2, 0},
                  {2, 2, 0},
                  {2, 1, 0},
                  {1, 1, 0}},
                 8.0);
}

TEST(Polygon, StarsOfManyCorners) {
  constexpr int kCorners = 400;
  constexpr double kPi = 3.14159265358979;
  std::vector<vec3> star;
  for (int i = 0; i < kCorners; ++i) {
    const double radius = i % 2 == 0 ? 2.0 : 1.0, angle = 2.0 * kPi * i / kCorners;
    star.emplace_back(radius * std::cos(angle), 0.5, -radius * std::sin(angle));
  }
  // Each of the 2n halves of a spike is a triangle of sides 1 and 2. Corners are floats.
  expect_covered(star, 0.5 * kCorners * 1.0 * 2.0 * std::sin(2.0 * kPi / kCorners));
}

TEST(Polygon, CrossedAndDegenerateOnesEnd) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
  int stuck = 0;
  std::vector<uint32_t> triangles;
  for (int polygon = 0; polygon < 200; ++polygon) {
    std::vector<vec3> corners(8);
    for (vec3& corner : corners) corner = {anywhere(random), anywhere(random), 0.0f};
    triangles.clear();
    if (!triangulate(corners, triangles)) ++stuck;
    EXPECT_LE(triangles.size(), 6u * 3u);
    for (const uint32_t corner : triangles) EXPECT_LT(corner, corners.size());
  }
  EXPECT_GT(stuck, 0);
  triangles.clear();
  triangulate(std::vector<vec3>(100, vec3(1.0f)), triangles);
  for (const uint32_t corner : triangles) EXPECT_LT(corner, 100u);
}

}  // namespace
}  // namespace lueur
