// SPDX-License-Identifier: MIT
#include "scene/builtin/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/check.h"
#include "scene/builtin/sample_lattice.h"

namespace lueur::builtin {
namespace {

// Edge e of a cell runs along axis e / 4 from the corner that lies at bits 0, 1 of e % 4 along the
// two axes after it.
constexpr glm::ivec3 edge_start(int edge) {
  const int axis = edge / 4;
  glm::ivec3 corner(0);
  corner[(axis + 1) % 3] = edge & 1;
  corner[(axis + 2) % 3] = (edge >> 1) & 1;
  return corner;
}

glm::ivec3 edge_end(int edge) {
  glm::ivec3 corner = edge_start(edge);
  corner[edge / 4] = 1;
  return corner;
}

int corner_number(glm::ivec3 corner) {
  return corner.x | (corner.y << 1) | (corner.z << 2);
}

// The pieces of surface in a cell, by the edges that each crosses.
struct Pieces {
  int count = 0;
  std::array<int, 12> of_edge;  // kNone where the surface does not cross
};

// Two crossed edges of one face bound the same piece.
Pieces find_pieces(unsigned mask) {
  Pieces pieces;
  for (int edge = 0; edge < 12; ++edge) {
    const bool start = (mask >> corner_number(edge_start(edge)) & 1) != 0;
    const bool end = (mask >> corner_number(edge_end(edge)) & 1) != 0;
    pieces.of_edge[edge] = start != end ? edge : kNone;
  }
  for (int pass = 0; pass < 12; ++pass) {
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2, side = face % 2;
      int least = 12;
      const auto on_face = [&](int edge) {
        return pieces.of_edge[edge] != kNone && edge_start(edge)[axis] == side &&
               edge_end(edge)[axis] == side;
      };
      for (int edge = 0; edge < 12; ++edge)
        if (on_face(edge)) least = std::min(least, pieces.of_edge[edge]);
      for (int edge = 0; edge < 12; ++edge)
        if (on_face(edge)) pieces.of_edge[edge] = least;
    }
  }

  // Number the pieces from 0.
  std::array<int, 12> number;
  number.fill(kNone);
  for (int& piece : pieces.of_edge) {
    if (piece == kNone) continue;
    if (number[piece] == kNone) number[piece] = pieces.count++;
    piece = number[piece];
  }
  return pieces;
}

const Pieces& pieces_of(unsigned mask) {
  static const std::vector<Pieces> table = [] {
    std::vector<Pieces> all;
    for (unsigned m = 0; m < 256; ++m) all.push_back(find_pieces(m));
    return all;
  }();
  return table[mask];
}

// The gradient, from four samples at the corners of a tetrahedron.
glm::vec3 gradient(const Isosurface& surface, glm::vec3 position, float step_m) {
  constexpr glm::vec3 kCorners[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  glm::vec3 sum(0.0f);
  for (const glm::vec3 corner : kCorners)
    sum += corner * surface.distance(position + corner * step_m);
  return sum / (4.0f * step_m);
}

class Mesher {
 public:
  Mesher(MeshBuilder& builder, const Isosurface& surface, const SampleLattice& lattice)
      : builder_(builder), surface_(surface), lattice_(lattice) {}

  void run() {
    place_points();
    for (int axis = 0; axis < 3; ++axis) add_faces(axis);
    builder_.add_indexed(vertices_, indices_);
  }

 private:
  struct Point {
    glm::vec3 position;
    glm::vec3 normal;
    std::array<uint32_t, 6> vertex;  // for each way a face can look, kNoVertex at first
  };
  static constexpr uint32_t kNoVertex = ~0u;

  size_t cell_index(glm::ivec3 cell) const {
    const glm::ivec3 cells = lattice_.cells();
    return (size_t(cell.z) * size_t(cells.y) + size_t(cell.y)) * size_t(cells.x) + size_t(cell.x);
  }

  // One point for each piece of surface in each cell.
  void place_points() {
    const glm::ivec3 cells = lattice_.cells();
    first_point_.assign(cell_index(cells - 1) + 1, 0);
    for (int z = 0; z < cells.z; ++z) {
      for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
          const unsigned mask = lattice_.mask({x, y, z});
          if (mask == 0 || mask == 255) continue;
          first_point_[cell_index({x, y, z})] = uint32_t(points_.size());
          const Pieces& pieces = pieces_of(mask);
          for (int piece = 0; piece < pieces.count; ++piece) place_point({x, y, z}, pieces, piece);
        }
      }
    }
  }

  void place_point(glm::ivec3 cell, const Pieces& pieces, int piece) {
    glm::vec3 sum(0.0f);
    float count = 0.0f;
    for (int edge = 0; edge < 12; ++edge) {
      if (pieces.of_edge[edge] != piece) continue;
      sum += lattice_.crossing(cell + edge_start(edge), cell + edge_end(edge));
      count += 1.0f;
    }

    // Walk from the middle of the crossings to the surface, but keep clear of the cell's faces: so
    // neighbours never meet, and triangles never turn over.
    const float cell_m = lattice_.cell_m(), margin = kMargin * cell_m;
    const glm::vec3 low = lattice_.position(cell) + margin;
    const glm::vec3 high = lattice_.position(cell + 1) - margin;
    Point point;
    point.position = glm::clamp(sum / count, low, high);
    const glm::vec3 slope = gradient(surface_, point.position, kStep * cell_m);
    const float steep = glm::dot(slope, slope);
    if (steep > 1e-6f) {
      const glm::vec3 walk = slope * (surface_.distance(point.position) / steep);
      point.position = glm::clamp(point.position - walk, low, high);
    }
    point.normal = gradient(surface_, point.position, kStep * cell_m);
    if (glm::length(point.normal) < 1e-3f) point.normal = {0, 1, 0};  // a ridge of the field
    point.normal = glm::normalize(point.normal);
    point.vertex.fill(kNoVertex);
    points_.push_back(point);
  }

  // A face around each crossed edge along `axis`, between the points of the four cells at it.
  void add_faces(int axis) {
    const int right = (axis + 1) % 3, up = (axis + 2) % 3;
    glm::ivec3 step(0), step_right(0), step_up(0);
    step[axis] = step_right[right] = step_up[up] = 1;
    const glm::ivec3 cells = lattice_.cells();

    // The surface keeps off the lattice's border, so that each edge has all four cells.
    for (int z = step.z == 0; z < cells.z; ++z) {
      for (int y = step.y == 0; y < cells.y; ++y) {
        for (int x = step.x == 0; x < cells.x; ++x) {
          const glm::ivec3 at(x, y, z);
          const bool start = lattice_.inside(at);
          if (start == lattice_.inside(at + step)) continue;
          const auto point = [&](int to_right, int to_up) {
            const glm::ivec3 cell = at - step_right * (1 - to_right) - step_up * (1 - to_up);
            const int edge = axis * 4 + (1 - to_right) + 2 * (1 - to_up);
            return first_point_[cell_index(cell)] +
                   uint32_t(pieces_of(lattice_.mask(cell)).of_edge[edge]);
          };
          std::array<uint32_t, 4> corners = {point(0, 0), point(1, 0), point(1, 1), point(0, 1)};
          if (!start) std::swap(corners[1], corners[3]);
          add_face(corners);
        }
      }
    }
  }

  void add_face(const std::array<uint32_t, 4>& corners) {
    glm::vec3 facing(0.0f);
    for (const uint32_t corner : corners) facing += points_[corner].normal;
    std::array<uint32_t, 4> vertex;
    for (int k = 0; k < 4; ++k) vertex[k] = vertex_of(points_[corners[k]], facing);

    // Cut along the shorter diagonal.
    const auto diagonal = [&](int k) {
      return glm::distance(points_[corners[k]].position, points_[corners[k + 2]].position);
    };
    const int first = diagonal(0) <= diagonal(1) ? 0 : 1;
    for (const int k : {first, first + 2})
      indices_.insert(indices_.end(), {vertex[k], vertex[(k + 1) % 4], vertex[(k + 2) % 4]});
  }

  // The point's vertex with the texture coordinates of a face that looks along `facing`.
  uint32_t vertex_of(Point& point, glm::vec3 facing) {
    const glm::vec3 size = glm::abs(facing);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    glm::vec3 direction(0.0f);
    direction[axis] = facing[axis] < 0.0f ? -1.0f : 1.0f;
    uint32_t& vertex = point.vertex[size_t(axis * 2 + (facing[axis] < 0.0f))];
    if (vertex == kNoVertex) {
      vertex = uint32_t(vertices_.size());
      vertices_.push_back({point.position, point.normal, planar_uv(point.position, direction)});
    }
    return vertex;
  }

  // In cells: what a point keeps off its cell's faces, and half the distance over which the
  // gradient is taken.
  static constexpr float kMargin = 0.02f;
  static constexpr float kStep = 0.2f;

  MeshBuilder& builder_;
  const Isosurface& surface_;
  const SampleLattice& lattice_;
  std::vector<Point> points_;
  std::vector<uint32_t> first_point_;  // of each cell that has one
  std::vector<SurfacePoint> vertices_;
  std::vector<uint32_t> indices_;
};

}  // namespace

void add_isosurface(MeshBuilder& builder, const Isosurface& surface, float cell_m) {
  const SampleLattice lattice(surface, cell_m);
  Mesher(builder, surface, lattice).run();
}

void add_isosurface_of(MeshBuilder& builder, const Isosurface& surface, uint32_t triangles) {
  LUEUR_CHECK_OP(triangles, >, 0u);
  const glm::vec3 size = surface.max - surface.min;
  float cell_m = std::max({size.x, size.y, size.z}) / 40.0f;
  for (int attempt = 0; attempt < 12; ++attempt) {
    const SampleLattice lattice(surface, cell_m);
    const double count = 2.0 * double(lattice.crossed_edges()), ratio = count / double(triangles);
    if (std::abs(ratio - 1.0) < 0.03) {
      Mesher(builder, surface, lattice).run();
      return;
    }
    cell_m *= float(count > 0.0 ? std::sqrt(ratio) : 0.5);
  }
  LUEUR_CHECK(false && "the surface's triangles follow from the cell's width");
}

}  // namespace lueur::builtin
