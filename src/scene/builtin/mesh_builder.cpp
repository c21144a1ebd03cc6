// SPDX-License-Identifier: MIT
#include "scene/builtin/mesh_builder.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace lueur::builtin {
namespace {

// Any unit vector at right angles to the unit vector `normal`.
glm::vec3 perpendicular(glm::vec3 normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
  return glm::normalize(axis - normal * glm::dot(axis, normal));
}

// Gives each vertex the direction in which its texture's u grows over the surface.
void set_tangents(Mesh& mesh) {
  std::vector<glm::vec3> along_u(mesh.vertices.size(), glm::vec3(0.0f));
  std::vector<glm::vec3> along_v(mesh.vertices.size(), glm::vec3(0.0f));

  // Sum over the triangles around each vertex, weighted by their extent in the texture.
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[k]];
    const Vertex& b = mesh.vertices[mesh.indices[k + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[k + 2]];
    const glm::vec3 e1 = b.position - a.position, e2 = c.position - a.position;
    const glm::vec2 d1 = b.uv - a.uv, d2 = c.uv - a.uv;
    const float side = d1.x * d2.y - d2.x * d1.y < 0.0f ? -1.0f : 1.0f;
    for (int corner = 0; corner < 3; ++corner) {
      along_u[mesh.indices[k + corner]] += side * (e1 * d2.y - e2 * d1.y);
      along_v[mesh.indices[k + corner]] += side * (e2 * d1.x - e1 * d2.x);
    }
  }

  // Bring the sums to right angles with the normal; v runs down, the bitangent up.
  for (size_t k = 0; k < mesh.vertices.size(); ++k) {
    const glm::vec3 normal = mesh.vertices[k].normal;
    glm::vec3 tangent = along_u[k] - normal * glm::dot(along_u[k], normal);
    const float length = glm::length(tangent);
    tangent = length > 1e-12f ? tangent / length : perpendicular(normal);
    const float w = glm::dot(glm::cross(normal, tangent), along_v[k]) > 0.0f ? -1.0f : 1.0f;
    mesh.vertices[k].tangent = glm::vec4(glm::normalize(tangent), w);
  }
}

}  // namespace

int Tessellation::flat(float length_m, int minimum) const {
  return std::max(minimum, int(std::lround(length_m / edge_m)));
}

int Tessellation::curved(float length_m, int minimum) const {
  return std::max(minimum, int(std::lround(2.0f * length_m / edge_m)));
}

void MeshBuilder::set_material(int32_t material, float texture_size_m) {
  LUEUR_CHECK_OP(texture_size_m, >, 0.0f);
  material_ = material;
  texture_size_m_ = texture_size_m;
}

uint32_t MeshBuilder::add_vertex(const SurfacePoint& point) {
  const glm::vec3 normal = glm::mat3(mesh_from_piece_) * point.normal;
  LUEUR_CHECK_OP(glm::length(normal), >, 0.0f);
  vertices_.push_back({glm::vec3(mesh_from_piece_ * glm::vec4(point.position, 1.0f)),
                       glm::normalize(normal), glm::vec4(0.0f), point.uv_m / texture_size_m_});
  return uint32_t(vertices_.size() - 1);
}

void MeshBuilder::add_triangle(uint32_t a, uint32_t b, uint32_t c) {
  triangles_.push_back({{a, b, c}, material_});
}

void MeshBuilder::add_grid(int cells_u, int cells_v, const SurfaceFunction& point_at, Poles poles) {
  LUEUR_CHECK_OP(cells_u, >, 0);
  LUEUR_CHECK_OP(cells_v, >, int(poles.first) + int(poles.last) - 1);
  const int skipped_rows = int(poles.first) + int(poles.last);
  triangle_count_ += uint64_t(cells_u) * uint64_t(2 * cells_v - skipped_rows);
  if (mode_ == Mode::count) return;

  const uint32_t first = uint32_t(vertices_.size());
  for (int j = 0; j <= cells_v; ++j)
    for (int i = 0; i <= cells_u; ++i) add_vertex(point_at(i, j));

  // Cut each cell in two; at a pole one half has no area and is left out.
  const auto at = [&](int i, int j) { return first + uint32_t(j * (cells_u + 1) + i); };
  for (int j = 0; j < cells_v; ++j) {
    for (int i = 0; i < cells_u; ++i) {
      const bool at_first = poles.first && j == 0;
      const bool at_last = poles.last && j == cells_v - 1;
      if (at_last) {
        add_triangle(at(i, j), at(i + 1, j), at(i, j + 1));
        continue;
      }
      if (!at_first) add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
}

void MeshBuilder::add_fan(glm::vec3 center, int rim_count,
                          const std::function<glm::vec3(int k)>& rim_at, glm::vec3 normal) {
  LUEUR_CHECK_OP(rim_count, >, 2);
  triangle_count_ += uint64_t(rim_count);
  if (mode_ == Mode::count) return;
  const uint32_t hub = add_vertex({center, normal, planar_uv(center, normal)});
  for (int k = 0; k < rim_count; ++k) {
    const glm::vec3 position = rim_at(k);
    add_vertex({position, normal, planar_uv(position, normal)});
  }
  for (int k = 0; k < rim_count; ++k)
    add_triangle(hub, hub + 1 + uint32_t(k), hub + 1 + uint32_t((k + 1) % rim_count));
}

void MeshBuilder::add_indexed(std::span<const SurfacePoint> points,
                              std::span<const uint32_t> indices) {
  LUEUR_CHECK_OP(indices.size() % 3, ==, 0u);
  triangle_count_ += indices.size() / 3;
  if (mode_ == Mode::count) return;
  const uint32_t first = uint32_t(vertices_.size());
  for (const SurfacePoint& point : points) add_vertex(point);
  for (size_t k = 0; k < indices.size(); k += 3)
    add_triangle(first + indices[k], first + indices[k + 1], first + indices[k + 2]);
}

Mesh MeshBuilder::finish(std::string name) {
  LUEUR_CHECK(mode_ == Mode::build);
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.vertices = std::move(vertices_);

  // Group the triangles by material, so that each material is one primitive.
  std::stable_sort(triangles_.begin(), triangles_.end(),
                   [](const Triangle& a, const Triangle& b) { return a.material < b.material; });
  mesh.indices.reserve(triangles_.size() * 3);
  for (const Triangle& triangle : triangles_) {
    if (mesh.primitives.empty() || mesh.primitives.back().material != triangle.material)
      mesh.primitives.push_back({uint32_t(mesh.indices.size()), 0, triangle.material});
    mesh.indices.insert(mesh.indices.end(), triangle.corner, triangle.corner + 3);
    mesh.primitives.back().index_count += 3;
  }
  set_tangents(mesh);
  vertices_.clear();
  triangles_.clear();
  triangle_count_ = 0;
  return mesh;
}

glm::vec2 planar_uv(glm::vec3 position, glm::vec3 normal) {
  // Horizontal faces take x and z; upright ones the horizontal direction to the right.
  if (std::abs(normal.y) > 0.9f) return {position.x, normal.y > 0 ? position.z : -position.z};
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), normal));
  return {glm::dot(position, right), -position.y};
}

glm::vec2 unit_circle_point(int k, int n) {
  const float angle = 2.0f * kPi * float(k % n) / float(n);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace lueur::builtin
