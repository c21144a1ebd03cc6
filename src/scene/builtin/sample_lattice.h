// SPDX-License-Identifier: MIT
// The samples of a distance function at the corners of cubic cells, made ready for meshing.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/builtin/isosurface.h"

namespace lueur::builtin {

// Corner k of a cell lies one step further in x, y, z where bit 0, 1, 2 of k is set.
constexpr glm::ivec3 cell_corner(int k) {
  return {k & 1, (k >> 1) & 1, (k >> 2) & 1};
}

class SampleLattice {
 public:
  // Samples `surface` near its zero only; elsewhere a corner knows just its side. No face of a cell
  // has its two inside corners across from each other: where the field did, one of the two
  // outside corners counts as inside. So how the surface crosses a face is never in doubt.
  SampleLattice(const Isosurface& surface, float cell_m);

  glm::ivec3 cells() const { return cells_; }
  float cell_m() const { return cell_m_; }
  glm::vec3 position(glm::ivec3 corner) const { return origin_ + glm::vec3(corner) * cell_m_; }
  bool inside(glm::ivec3 corner) const { return value_[index(corner)] < 0.0f; }

  // Bit k is set where corner k of the cell is inside.
  unsigned mask(glm::ivec3 cell) const;

  // Where the surface crosses the edge between two neighbouring corners, one of them inside.
  glm::vec3 crossing(glm::ivec3 a, glm::ivec3 b) const;

  // Edges that the surface crosses: each becomes a four-sided face.
  uint64_t crossed_edges() const;

 private:
  size_t index(glm::ivec3 corner) const {
    return (size_t(corner.z) * size_t(corners_.y) + size_t(corner.y)) * size_t(corners_.x) +
           size_t(corner.x);
  }
  void sample_block(const Isosurface& surface, glm::ivec3 first, int size);
  bool settle_faces();

  glm::ivec3 cells_, corners_;
  float cell_m_;
  glm::vec3 origin_;
  std::vector<float> value_;  // ±infinity: not sampled, but on this side
};

}  // namespace lueur::builtin
