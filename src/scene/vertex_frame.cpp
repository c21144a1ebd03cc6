// SPDX-License-Identifier: MIT
#include "scene/vertex_frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lueur {
namespace {

using glm::vec3;
using glm::vec4;

constexpr vec3 kUp{0.0f, 1.0f, 0.0f};

// In double precision, so that neither tiny nor huge models lose their direction to underflow.
vec3 normalize_or(const glm::dvec3& direction, const vec3& fallback) {
  const double length = glm::length(direction);
  return length > 0.0 && std::isfinite(length) ? vec3(direction / length) : fallback;
}

// Twice the area, along the face's normal.
glm::dvec3 area_normal(const vec3& a, const vec3& b, const vec3& c) {
  return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

vec3 any_orthogonal(const vec3& normal) {
  const vec3 axis = std::abs(normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
  return glm::normalize(axis - normal * glm::dot(normal, axis));
}

// The part of `tangent` orthogonal to `normal`, unit length.
vec3 orthogonal_to(const vec3& normal, const glm::dvec3& tangent) {
  const glm::dvec3 n(normal);
  const glm::dvec3 unit(normalize_or(tangent, vec3(0.0f)));
  const glm::dvec3 rest = unit - n * glm::dot(n, unit);
  constexpr double kParallel = 1e-4;  // below this the rest is rounding
  return glm::length(rest) > kParallel ? vec3(glm::normalize(rest)) : any_orthogonal(normal);
}

struct TextureAxes {
  glm::dvec3 along_u{0.0};
  glm::dvec3 along_v{0.0};
};

// For each vertex the directions in which u and v grow, summed over its triangles.
std::vector<TextureAxes> sum_texture_axes(std::span<const Vertex> vertices,
                                          std::span<const uint32_t> indices) {
  std::vector<TextureAxes> axes(vertices.size());
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Vertex& a = vertices[indices[i]];
    const Vertex& b = vertices[indices[i + 1]];
    const Vertex& c = vertices[indices[i + 2]];
    const glm::dvec3 edge_1 = glm::dvec3(b.position) - glm::dvec3(a.position);
    const glm::dvec3 edge_2 = glm::dvec3(c.position) - glm::dvec3(a.position);
    const glm::dvec2 uv_1 = glm::dvec2(b.uv) - glm::dvec2(a.uv);
    const glm::dvec2 uv_2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    // Solve edge = uv.x * along_u + uv.y * along_v, and keep only the sign of the determinant:
    // divided by it, slivers in texture space would outweigh all others.
    const double determinant = uv_1.x * uv_2.y - uv_2.x * uv_1.y;
    if (determinant == 0.0) continue;
    const double sign = determinant > 0.0 ? 1.0 : -1.0;
    for (size_t corner = 0; corner < 3; ++corner) {
      axes[indices[i + corner]].along_u += (edge_1 * uv_2.y - edge_2 * uv_1.y) * sign;
      axes[indices[i + corner]].along_v += (edge_2 * uv_1.x - edge_1 * uv_2.x) * sign;
    }
  }
  return axes;
}

}  // namespace

void make_flat_normals(std::span<Vertex> vertices) {
  for (size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const vec3 normal = normalize_or(
        area_normal(vertices[i].position, vertices[i + 1].position, vertices[i + 2].position), kUp);
    for (size_t corner = 0; corner < 3; ++corner) vertices[i + corner].normal = normal;
  }
}

uint64_t repair_normals(std::span<Vertex> vertices, std::span<const uint32_t> indices) {
  uint64_t zero_count = 0;
  for (Vertex& vertex : vertices) {
    vertex.normal = normalize_or(glm::dvec3(vertex.normal), vec3(0.0f));
    if (vertex.normal == vec3(0.0f)) ++zero_count;
  }
  if (zero_count == 0) return 0;

  std::vector<glm::dvec3> sums(vertices.size(), glm::dvec3(0.0));
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 normal =
        area_normal(vertices[indices[i]].position, vertices[indices[i + 1]].position,
                    vertices[indices[i + 2]].position);
    for (size_t corner = 0; corner < 3; ++corner) sums[indices[i + corner]] += normal;
  }
  for (size_t i = 0; i < vertices.size(); ++i)
    if (vertices[i].normal == vec3(0.0f)) vertices[i].normal = normalize_or(sums[i], kUp);
  return zero_count;
}

void make_tangents(std::span<Vertex> vertices, std::span<const uint32_t> indices) {
  const auto is_missing = [](const Vertex& vertex) { return vertex.tangent.w == 0.0f; };
  std::vector<TextureAxes> axes;
  if (std::any_of(vertices.begin(), vertices.end(), is_missing))
    axes = sum_texture_axes(vertices, indices);
  for (size_t i = 0; i < vertices.size(); ++i) {
    Vertex& vertex = vertices[i];
    if (!is_missing(vertex)) {
      const vec3 given = orthogonal_to(vertex.normal, glm::dvec3(vec3(vertex.tangent)));
      vertex.tangent = vec4(given, vertex.tangent.w < 0.0f ? -1.0f : 1.0f);
      continue;
    }
    // glTF's v points down in the picture and its bitangent up: along -v.
    const vec3 tangent = orthogonal_to(vertex.normal, axes[i].along_u);
    const glm::dvec3 bitangent = glm::cross(glm::dvec3(vertex.normal), glm::dvec3(tangent));
    const bool mirrored = glm::dot(bitangent, axes[i].along_v) > 0.0;
    vertex.tangent = vec4(tangent, mirrored ? -1.0f : 1.0f);
  }
}

}  // namespace lueur
