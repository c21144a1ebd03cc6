// SPDX-License-Identifier: MIT
#include "scene/watertight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lueur {
namespace {

// Numbers in sets that grow together; a set is named by its least number.
class Sets {
 public:
  explicit Sets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  uint32_t of(uint32_t number) {
    while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
    return number;
  }
  void join(uint32_t a, uint32_t b) {
    const auto [low, high] = std::minmax({of(a), of(b)});
    parent_[high] = low;
  }

 private:
  std::vector<uint32_t> parent_;
};

// The cell that a position is in, of a grid that is moved along its diagonal by a share of a cell.
uint64_t cell_of(const glm::vec3& p, float cell_m, float moved) {
  constexpr float kMost = 1 << 20;
  uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float place = std::floor(p[axis] / cell_m + moved) + kMost;
    key = key << 21 | static_cast<uint64_t>(place);
  }
  return key;
}

// Of each vertex, one of those at its position: the same for all of them.
std::vector<uint32_t> weld(const std::vector<Vertex>& vertices) {
  float farthest_m = std::numeric_limits<float>::min();
  for (const Vertex& vertex : vertices)
    for (int axis = 0; axis < 3; ++axis)
      farthest_m = std::max(farthest_m, std::abs(vertex.position[axis]));
  // Whoever is in one cell is at one position. A cell's border can part what is close together, but
  // along each axis it does so in one of four grids at most, so that one of them is left.
  constexpr int kGrids = 4;
  const float cell_m = kGrids * kWeldDistance * farthest_m;
  Sets positions(vertices.size());
  std::vector<std::pair<uint64_t, uint32_t>> cells(vertices.size());
  for (int grid = 0; grid < kGrids; ++grid) {
    const float moved = (static_cast<float>(grid) + 0.5f) / kGrids;
    for (uint32_t i = 0; i < vertices.size(); ++i)
      cells[i] = {cell_of(vertices[i].position, cell_m, moved), i};
    std::sort(cells.begin(), cells.end());
    for (size_t i = 1; i < cells.size(); ++i)
      if (cells[i].first == cells[i - 1].first)
        positions.join(cells[i - 1].second, cells[i].second);
  }
  std::vector<uint32_t> welded(vertices.size());
  for (uint32_t i = 0; i < vertices.size(); ++i) welded[i] = positions.of(i);
  return welded;
}

// An edge as one triangle has it.
struct HalfEdge {
  uint64_t ends;  // lower vertex, higher vertex
  uint32_t triangle;
  bool is_upward;  // from the lower vertex to the higher one
};

std::vector<HalfEdge> half_edges(const Mesh& mesh) {
  const std::vector<uint32_t> welded = weld(mesh.vertices);
  std::vector<HalfEdge> edges;
  edges.reserve(mesh.indices.size());
  for (size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    uint32_t corner[3];
    for (size_t k = 0; k < 3; ++k) corner[k] = welded[mesh.indices[first + k]];
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = corner[k], b = corner[(k + 1) % 3];
      edges.push_back({uint64_t{std::min(a, b)} << 32 | std::max(a, b),
                       static_cast<uint32_t>(first / 3), a < b});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& a, const HalfEdge& b) { return a.ends < b.ends; });
  return edges;
}

// Calls `visit(first, last, is_balanced)` for each edge's half edges.
template <class Visit>
void for_each_edge(const std::vector<HalfEdge>& edges, const Visit& visit) {
  for (size_t first = 0, last = 0; first < edges.size(); first = last) {
    int64_t balance = 0;
    for (; last < edges.size() && edges[last].ends == edges[first].ends; ++last)
      balance += edges[last].is_upward ? 1 : -1;
    visit(first, last, balance == 0);
  }
}

// By component: twice the volume within its triangles over their area.
std::vector<float> thickness_of(const Mesh& mesh, Sets& components) {
  struct Measure {
    double volume = 0.0, area = 0.0;
    glm::dvec3 origin{};
  };
  const size_t triangles = mesh.indices.size() / 3;
  std::vector<Measure> measures(triangles);
  for (uint32_t i = 0; i < triangles; ++i) {
    const auto corner = [&](uint32_t k) {
      return glm::dvec3(mesh.vertices[mesh.indices[3 * i + k]].position);
    };
    Measure& measure = measures[components.of(i)];
    // Near the component, or what is far from the origin would be small differences. A set is named
    // by its first triangle.
    if (components.of(i) == i) measure.origin = corner(0);
    const glm::dvec3 a = corner(0) - measure.origin;
    const glm::dvec3 b = corner(1) - measure.origin, c = corner(2) - measure.origin;
    measure.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    measure.area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  std::vector<float> thickness_m;
  for (const Measure& measure : measures)
    thickness_m.push_back(measure.area > 0.0
                              ? static_cast<float>(2.0 * std::abs(measure.volume) / measure.area)
                              : 0.0f);
  return thickness_m;
}

}  // namespace

Watertightness watertightness(const Mesh& mesh) {
  const std::vector<HalfEdge> edges = half_edges(mesh);
  const size_t triangles = mesh.indices.size() / 3;
  Sets components(triangles);
  for_each_edge(edges, [&](size_t first, size_t last, bool) {
    for (size_t i = first + 1; i < last; ++i)
      components.join(edges[first].triangle, edges[i].triangle);
  });
  std::vector<uint32_t> open_edges(triangles);  // by component
  for_each_edge(edges, [&](size_t first, size_t, bool is_balanced) {
    if (!is_balanced) ++open_edges[components.of(edges[first].triangle)];
  });

  Watertightness found;
  found.is_closed.assign(triangles, true);
  found.thickness_m.assign(triangles, 0.0f);
  const std::vector<float> thickness_m = thickness_of(mesh, components);
  found.closed_triangles = edges.size() / 3;
  for (uint32_t i = 0; i < triangles; ++i) {
    const uint32_t open = open_edges[components.of(i)];
    if (open == 0) {
      found.thickness_m[i] = thickness_m[components.of(i)];
      continue;
    }
    found.is_closed[i] = false;
    ++found.open_triangles;
    --found.closed_triangles;
    if (found.open_edges == 0) found.open_edges = open;
  }
  return found;
}

}  // namespace lueur
