// SPDX-License-Identifier: MIT
#include "scene/watertight.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/builtin/shapes.h"

namespace lueur {
namespace {

Mesh box() {
  builtin::MeshBuilder builder;
  builtin::add_box(builder, {-1, -1, -1}, {1, 1, 1}, {100.0f});
  return builder.finish("box");
}

Mesh sphere(int cells) {
  builtin::MeshBuilder builder;
  builtin::add_sphere(builder, {0, 3, 0}, 1.0f, cells);
  return builder.finish("sphere");
}

void expect_counts(const Mesh& mesh, uint64_t closed, uint64_t open, uint64_t edges) {
  const Watertightness w = watertightness(mesh);
  EXPECT_EQ(w.closed_triangles, closed);
  EXPECT_EQ(w.open_triangles, open);
  EXPECT_EQ(w.open_edges, edges);
  EXPECT_EQ(w.is_closed.size(), mesh.indices.size() / 3);
  EXPECT_EQ(std::count(w.is_closed.begin(), w.is_closed.end(), false), static_cast<int64_t>(open));
}

void append(Mesh& mesh, const Mesh& other) {
  const auto offset = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const uint32_t index : other.indices) mesh.indices.push_back(index + offset);
}

TEST(Watertight, ABoxIsClosedThoughItsFacesShareNoVertices) {
  const Mesh mesh = box();
  ASSERT_GE(mesh.vertices.size(), 24u);
  expect_counts(mesh, 12, 0, 0);
}

TEST(Watertight, ASphereIsClosedAcrossItsSeam) {
  const Mesh mesh = sphere(16);
  expect_counts(mesh, mesh.indices.size() / 3, 0, 0);
}

TEST(Watertight, AMissingTriangleOpensItsComponent) {
  Mesh mesh = box();
  mesh.indices.resize(mesh.indices.size() - 3);
  expect_counts(mesh, 0, 11, 3);
  mesh.indices.resize(mesh.indices.size() - 3);  // the other half of the face
  expect_counts(mesh, 0, 10, 4);
}

TEST(Watertight, AComponentDoesNotSpoilAnother) {
  Mesh mesh = box();
  mesh.indices.resize(mesh.indices.size() - 3);
  const Mesh ball = sphere(8);
  const uint64_t of_ball = ball.indices.size() / 3;
  append(mesh, ball);
  expect_counts(mesh, of_ball, 11, 3);
  const Watertightness w = watertightness(mesh);
  EXPECT_FALSE(w.is_closed[10]);
  EXPECT_TRUE(w.is_closed[11]);
}

TEST(Watertight, AFlippedFaceOpensItsComponent) {
  Mesh mesh = box();
  std::swap(mesh.indices[0], mesh.indices[1]);
  expect_counts(mesh, 0, 12, 3);
  // All flipped: inside out, and closed.
  Mesh inside_out = box();
  for (size_t i = 0; i < inside_out.indices.size(); i += 3)
    std::swap(inside_out.indices[i], inside_out.indices[i + 1]);
  expect_counts(inside_out, 12, 0, 0);
}

TEST(Watertight, SolidsThatTouchAlongAnEdgeAreClosed) {
  Mesh mesh = box();
  Mesh other = box();
  for (Vertex& vertex : other.vertices) vertex.position += glm::vec3(2, 2, 0);
  append(mesh, other);
  expect_counts(mesh, 24, 0, 0);
}

TEST(Watertight, TrianglesWithoutAreaAreIgnored) {
  Mesh mesh = box();
  mesh.indices.insert(mesh.indices.end(), {0, 0, 1});
  expect_counts(mesh, 12, 0, 0);
}

// Wherever the borders of grids lie.
TEST(Watertight, VerticesThatRoundingMovedAreOne) {
  for (int i = 0; i < 2000; ++i) {
    Mesh mesh = box();
    const glm::vec3 moved = static_cast<float>(i) * glm::vec3(1.7e-7f, 2.3e-7f, 1.1e-7f);
    for (size_t k = 0; k < mesh.vertices.size(); ++k)
      mesh.vertices[k].position += moved + (k % 2 == 0 ? 5e-7f : 0.0f);
    const Watertightness w = watertightness(mesh);
    ASSERT_EQ(w.open_triangles, 0u) << i;
    ASSERT_EQ(w.closed_triangles, 12u) << i;
  }
}

TEST(Watertight, AGapIsAGap) {
  Mesh mesh = box();
  mesh.vertices[0].position.x += 1e-4f;
  expect_counts(mesh, 0, 12, 4);
}

TEST(Watertight, ThicknessIsTwiceTheVolumeOverTheArea) {
  Mesh mesh = box();
  for (Vertex& vertex : mesh.vertices) {
    vertex.position.z *= 0.01f;  // 2 x 2 x 0.02 m
    vertex.position += glm::vec3(1000, 500, 200);
  }
  append(mesh, sphere(64));
  append(mesh, box());
  mesh.indices.resize(mesh.indices.size() - 3);
  const Watertightness w = watertightness(mesh);
  ASSERT_EQ(w.thickness_m.size(), w.is_closed.size());
  EXPECT_NEAR(w.thickness_m[0], 2 * 0.08 / 8.16, 1e-4);  // rounding of positions
  EXPECT_NEAR(w.thickness_m[12], 2.0 / 3.0, 0.01);
  EXPECT_EQ(w.thickness_m[12], w.thickness_m[13]);
  EXPECT_EQ(w.thickness_m.back(), 0.0f);
}

TEST(Watertight, OfNothing) {
  expect_counts({}, 0, 0, 0);
}

}  // namespace
}  // namespace lueur
