// SPDX-License-Identifier: MIT
// Collects the vertices and triangles of one mesh from parametric pieces. Pieces that share an edge
// must sample it at the same points; a closed mesh then has every edge once in each direction.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace lueur::builtin {

inline constexpr float kPi = 3.14159265358979f;

// How finely curved and flat things are cut. One number steers a whole scene.
struct Tessellation {
  float edge_m = 0.25f;  // length of an edge on a flat surface; curved ones take half of it

  // Cells for a straight run of `length_m`, and for a curved one, at least `minimum`.
  int flat(float length_m, int minimum = 1) const;
  int curved(float length_m, int minimum) const;

  // Whether ornament of this size is worth its triangles: coarse scenes leave it out.
  bool shows(float size_m) const { return edge_m < 5.0f * size_m; }
};

struct SurfacePoint {
  glm::vec3 position;
  glm::vec3 normal;  // need not be unit length
  glm::vec2 uv_m;    // in metres: x to the right seen from outside, y downwards
};

// In `count` mode nothing is stored and only `triangle_count()` is kept, so that a tessellation can
// be searched for cheaply; surface functions are then never called.
class MeshBuilder {
 public:
  enum class Mode { build, count };
  explicit MeshBuilder(Mode mode = Mode::build) : mode_(mode) {}

  // Material of what follows; one repeat of its textures covers `texture_size_m` metres.
  void set_material(int32_t material, float texture_size_m = 1.0f);

  // Rigid transform (rotation and translation) of what follows; identity at first.
  void set_transform(const glm::mat4& mesh_from_piece) { mesh_from_piece_ = mesh_from_piece; }

  // A grid of `cells_u` x `cells_v` cells with corners `point_at(i, j)`. The outside is where
  // d/di × d/dj points. A pole is an edge of the grid (j = 0 or j = cells_v) that is one point.
  using SurfaceFunction = std::function<SurfacePoint(int i, int j)>;
  struct Poles {
    bool first = false;
    bool last = false;
  };
  void add_grid(int cells_u, int cells_v, const SurfaceFunction& point_at, Poles poles);
  void add_grid(int cells_u, int cells_v, const SurfaceFunction& point_at) {
    add_grid(cells_u, cells_v, point_at, Poles{});
  }

  // A flat face as a fan around `center`. `rim_at(k)`, k < rim_count, gives the closed rim counter-
  // clockwise as seen from where `normal` points.
  void add_fan(glm::vec3 center, int rim_count, const std::function<glm::vec3(int k)>& rim_at,
               glm::vec3 normal);

  // Any piece: three `indices` into `points` a triangle, counter-clockwise from outside.
  void add_indexed(std::span<const SurfacePoint> points, std::span<const uint32_t> indices);

  bool counts_only() const { return mode_ == Mode::count; }
  uint64_t triangle_count() const { return triangle_count_; }

  // The mesh, with tangents that follow the texture coordinates (bitangent towards the top of the
  // texture). The builder is empty afterwards. Not for `count` mode.
  Mesh finish(std::string name);

 private:
  struct Triangle {
    uint32_t corner[3];
    int32_t material;
  };

  uint32_t add_vertex(const SurfacePoint& point);
  void add_triangle(uint32_t a, uint32_t b, uint32_t c);

  Mode mode_;
  int32_t material_ = 0;
  float texture_size_m_ = 1.0f;
  glm::mat4 mesh_from_piece_{1.0f};
  uint64_t triangle_count_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
};

// Texture coordinates (metres) of a point on a flat face: across and down as seen from outside.
glm::vec2 planar_uv(glm::vec3 position, glm::vec3 normal);

// Point k of n on the unit circle; point n is point 0 to the bit, so that seams close.
glm::vec2 unit_circle_point(int k, int n);

// From a at k = 0 to b at k = n, both exact.
inline glm::vec3 mix_exact(glm::vec3 a, glm::vec3 b, int k, int n) {
  return k == 0 ? a : k == n ? b : a + (b - a) * (float(k) / float(n));
}

}  // namespace lueur::builtin
