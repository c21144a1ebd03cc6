// SPDX-License-Identifier: MIT
#include "scene/builtin/isosurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/sdf.h"

namespace lueur::builtin {
namespace {

Mesh mesh_of(const Isosurface& surface, float cell_m) {
  MeshBuilder builder;
  add_isosurface(builder, surface, cell_m);
  return builder.finish("surface");
}

// Vertices at the same place to the bit get one number: those doubled for their coordinates.
std::vector<uint32_t> numbers(const Mesh& mesh) {
  std::map<std::tuple<float, float, float>, uint32_t> places;
  std::vector<uint32_t> result;
  for (const Vertex& v : mesh.vertices)
    result.push_back(
        places.try_emplace({v.position.x, v.position.y, v.position.z}, uint32_t(places.size()))
            .first->second);
  return result;
}

// Each directed edge occurs once, and so does the one that runs the other way.
void expect_manifold(const Mesh& mesh) {
  const std::vector<uint32_t> number = numbers(mesh);
  std::set<std::pair<uint32_t, uint32_t>> edges;
  for (size_t k = 0; k < mesh.indices.size(); ++k) {
    const size_t next = k % 3 == 2 ? k - 2 : k + 1;
    const auto edge = std::pair(number[mesh.indices[k]], number[mesh.indices[next]]);
    EXPECT_NE(edge.first, edge.second);
    EXPECT_TRUE(edges.insert(edge).second);
  }
  EXPECT_FALSE(edges.empty());
  for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a}));
}

struct Measure {
  double area = 0.0;
  double volume = 0.0;
  double smallest_area = INFINITY;
};
Measure measure(const Mesh& mesh) {
  Measure sum;
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const glm::dvec3 a = mesh.vertices[mesh.indices[k]].position;
    const glm::dvec3 b = mesh.vertices[mesh.indices[k + 1]].position;
    const glm::dvec3 c = mesh.vertices[mesh.indices[k + 2]].position;
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    sum.area += area;
    sum.smallest_area = std::min(sum.smallest_area, area);
    sum.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return sum;
}

TEST(Isosurface, SphereHasItsVolumeAreaAndNormals) {
  constexpr float kRadius = 0.7f, kCell = 0.05f;
  constexpr glm::vec3 kCenter{0.1f, -0.2f, 0.3f};
  const Mesh mesh =
      mesh_of({.distance = [=](glm::vec3 p) { return sdf::sphere(p, kCenter, kRadius); }}, kCell);
  expect_manifold(mesh);

  // A chord of length c lies c² / 8r under the sphere, and chords are no longer than a cell's
  // diagonal; points lie off it by no more than the 0.02 of a cell along each axis that they keep
  // off the cell's faces. Volume and area are off by three and two times that in r.
  const double off = std::sqrt(3.0) * 0.02 * kCell, sag = 3.0 * kCell * kCell / (8.0 * kRadius);
  const Measure found = measure(mesh);
  const double volume = 4.0 / 3.0 * kPi * std::pow(kRadius, 3);
  const double area = 4.0 * kPi * kRadius * kRadius;
  EXPECT_NEAR(found.volume, volume, volume * 3.0 * (sag + off) / kRadius);
  EXPECT_NEAR(found.area, area, area * 2.0 * (sag + off) / kRadius);
  EXPECT_GT(found.smallest_area, 1e-4 * kCell * kCell);
  for (const Vertex& v : mesh.vertices) {
    EXPECT_NEAR(glm::distance(v.position, kCenter), kRadius, off + 1e-4);
    EXPECT_GT(glm::dot(v.normal, glm::normalize(v.position - kCenter)), 0.9999f);
  }
}

TEST(Isosurface, StaysAManifoldInNoise) {
  // Random values at every corner: all that a cell can hold, ambiguous faces among it.
  for (uint32_t seed = 0; seed < 20; ++seed) {
    const auto noise = [=](glm::vec3 p) {
      const glm::ivec3 corner = glm::ivec3(glm::round(p * 10.0f)) + 100;
      const float edge = sdf::box(p, glm::vec3(0), glm::vec3(0.8f));
      return std::max(hash_unit(uint32_t(corner.x + 1000 * corner.y), uint32_t(corner.z), seed) -
                          0.2f - 0.03f * float(seed),
                      edge);
    };
    expect_manifold(mesh_of({.distance = noise, .steepness = 1e3f}, 0.1f));
  }
}

TEST(Isosurface, SeesThinSheetsAndManyPieces) {
  // Two plates a cell and a half thick, and a small ball in a far corner.
  const auto field = [](glm::vec3 p) {
    return std::min({sdf::box(p, {0, 0.1f, 0}, {0.7f, 0.03f, 0.7f}),
                     sdf::box(p, {0, -0.1f, 0}, {0.7f, 0.03f, 0.7f}),
                     sdf::sphere(p, {-0.8f, 0.8f, -0.8f}, 0.1f)});
  };
  const Mesh mesh = mesh_of({.distance = field}, 0.04f);
  expect_manifold(mesh);
  const double expected = 2.0 * 1.4 * 1.4 * 0.06 + 4.0 / 3.0 * kPi * 0.001;
  EXPECT_NEAR(measure(mesh).volume, expected, 0.05 * expected);  // edges are rounded
}

TEST(Isosurface, LeavesOutNothingThatTheFieldReaches) {
  // The same mesh as when every block is sampled, which a steep field asks for.
  const auto field = [](glm::vec3 p) {
    return sdf::smooth_min(sdf::torus(p, {0, 0, 0}, {0, 1, 0}, 0.6f, 0.15f),
                           sdf::cone(p, {0, -0.5f, 0}, {0, 0.7f, 0}, 0.2f, 0.05f), 0.1f);
  };
  const Mesh sparse = mesh_of({.distance = field, .steepness = 1.2f}, 0.03f);
  const Mesh dense = mesh_of({.distance = field, .steepness = 1e3f}, 0.03f);
  EXPECT_EQ(sparse.indices, dense.indices);
  expect_manifold(sparse);
}

TEST(Isosurface, MeetsTheTriangleCount) {
  const Isosurface surface{.distance = [](glm::vec3 p) {
    return sdf::torus(p, {0, 0, 0}, {0, 1, 0}, 0.6f, 0.2f);
  }};
  for (const uint32_t triangles : {500u, 5'000u, 60'000u}) {
    MeshBuilder builder;
    add_isosurface_of(builder, surface, triangles);
    EXPECT_NEAR(double(builder.triangle_count()), triangles, 0.03 * triangles);
  }
}

TEST(Isosurface, TextureCoordinatesAreMetresOnTheSurface) {
  // On a box each face has the coordinates of a flat face; no triangle mixes two.
  const Mesh mesh = mesh_of(
      {.distance = [](glm::vec3 p) { return sdf::box(p, {}, glm::vec3(0.5f), 0.1f); }}, 0.04f);
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const Vertex* v[3];
    for (size_t c = 0; c < 3; ++c) v[c] = &mesh.vertices[mesh.indices[k + c]];
    const glm::vec2 d1 = v[1]->uv - v[0]->uv, d2 = v[2]->uv - v[0]->uv;
    const float in_texture = 0.5f * std::abs(d1.x * d2.y - d2.x * d1.y);
    const float in_space = 0.5f * glm::length(glm::cross(v[1]->position - v[0]->position,
                                                         v[2]->position - v[0]->position));
    // The surface leans by no more than the space diagonal to an axis, and half a cell's turn.
    EXPECT_LE(in_texture, in_space * 1.001f);
    EXPECT_GE(in_texture, in_space * 0.4f);
  }
}

TEST(Sdf, DistancesAreThoseOfTheSolids) {
  EXPECT_FLOAT_EQ(sdf::capsule({0, 2, 0}, {-1, 0, 0}, {1, 0, 0}, 0.5f), 1.5f);
  EXPECT_FLOAT_EQ(sdf::capsule({3, 0, 0}, {-1, 0, 0}, {1, 0, 0}, 0.5f), 1.5f);
  EXPECT_FLOAT_EQ(sdf::box({2, 2, 0}, {}, {1, 1, 1}), std::sqrt(2.0f));
  EXPECT_FLOAT_EQ(sdf::box({0.25f, 0, 0}, {}, {1, 1, 1}), -0.75f);
  EXPECT_FLOAT_EQ(sdf::box({2, 0, 0}, {}, {1, 1, 1}, 0.3f), 1.0f);
  EXPECT_FLOAT_EQ(sdf::torus({0, 0, 0.5f}, {}, {0, 0, 1}, 1.0f, 0.1f), std::sqrt(1.25f) - 0.1f);
  EXPECT_FLOAT_EQ(sdf::cone({1, 1, 0}, {0, 0, 0}, {0, 2, 0}, 0.4f, 0.2f), 0.7f);
  EXPECT_FLOAT_EQ(sdf::ellipsoid({0, 0, 3}, {}, {1, 2, 3}), 0.0f);
}

TEST(Sdf, SmoothJoinsDifferFromSharpOnesOnlyNearby) {
  EXPECT_FLOAT_EQ(sdf::smooth_min(0.1f, 0.5f, 0.2f), 0.1f);
  EXPECT_FLOAT_EQ(sdf::smooth_min(0.3f, 0.3f, 0.2f), 0.25f);  // a quarter of the width
  EXPECT_FLOAT_EQ(sdf::smooth_max(0.1f, 0.5f, 0.2f), 0.5f);
  EXPECT_FLOAT_EQ(sdf::smooth_max(0.3f, 0.3f, 0.2f), 0.35f);
}

}  // namespace
}  // namespace lueur::builtin
