// SPDX-License-Identifier: MIT
#include "scene/builtin/sample_lattice.h"

#include <cmath>
#include <limits>

#include "base/check.h"

namespace lueur::builtin {
namespace {

constexpr int kLargestBlock = 32;  // cells a side; halved down to the smallest
constexpr int kSmallestBlock = 4;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

SampleLattice::SampleLattice(const Isosurface& surface, float cell_m) : cell_m_(cell_m) {
  LUEUR_CHECK_OP(cell_m, >, 0.0f);
  const glm::vec3 size = surface.max - surface.min;
  cells_ = glm::ivec3(glm::ceil(size / cell_m)) + 2;  // one empty cell around it
  corners_ = cells_ + 1;
  LUEUR_CHECK_OP(double(corners_.x) * corners_.y * corners_.z, <, 1e9);
  origin_ = 0.5f * (surface.min + surface.max - glm::vec3(cells_) * cell_m);
  value_.assign(index(corners_ - 1) + 1, std::numeric_limits<float>::quiet_NaN());

  for (int z = 0; z < cells_.z; z += kLargestBlock)
    for (int y = 0; y < cells_.y; y += kLargestBlock)
      for (int x = 0; x < cells_.x; x += kLargestBlock)
        sample_block(surface, {x, y, z}, kLargestBlock);
  while (settle_faces()) {
  }
}

void SampleLattice::sample_block(const Isosurface& surface, glm::ivec3 first, int size) {
  if (glm::any(glm::greaterThanEqual(first, cells_))) return;
  const glm::ivec3 last = glm::min(first + size, cells_);

  // Leave a block out that the surface cannot reach; what a neighbour sampled stays.
  const glm::vec3 half = 0.5f * cell_m_ * glm::vec3(last - first);
  const float at_center = surface.distance(position(first) + half);
  const bool reached = std::abs(at_center) <= 1.001f * surface.steepness * glm::length(half);
  if (reached && size > kSmallestBlock) {
    for (int k = 0; k < 8; ++k)
      sample_block(surface, first + cell_corner(k) * (size / 2), size / 2);
    return;
  }
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        float& value = value_[index({x, y, z})];
        if (std::isfinite(value)) continue;
        if (reached) {
          value = surface.distance(position({x, y, z}));
          LUEUR_CHECK(std::isfinite(value));
        } else if (std::isnan(value)) {
          value = std::copysign(kInfinity, at_center);
        }
        const bool at_border =
            x == 0 || y == 0 || z == 0 || x == cells_.x || y == cells_.y || z == cells_.z;
        LUEUR_CHECK(!at_border || value > 0.0f);
      }
    }
  }
}

// Goes once over all faces; true if it changed a corner. As corners only ever become inside, a
// repeat comes to an end.
bool SampleLattice::settle_faces() {
  bool changed = false;
  const size_t step[3] = {index({1, 0, 0}), index({0, 1, 0}), index({0, 0, 1})};
  for (int axis = 0; axis < 3; ++axis) {
    const size_t right = step[(axis + 1) % 3], up = step[(axis + 2) % 3];
    glm::ivec3 end = corners_;
    --end[(axis + 1) % 3];
    --end[(axis + 2) % 3];
    for (int z = 0; z < end.z; ++z) {
      for (int y = 0; y < end.y; ++y) {
        size_t at = index({0, y, z});
        for (int x = 0; x < end.x; ++x, ++at) {
          const bool corner = value_[at] < 0.0f, across = value_[at + right + up] < 0.0f;
          const bool beside = value_[at + right] < 0.0f, above = value_[at + up] < 0.0f;
          if (corner != across || beside != above || corner == beside) continue;
          const size_t a = corner ? at + right : at, b = corner ? at + up : at + right + up;
          value_[value_[a] < value_[b] ? a : b] = -std::numeric_limits<float>::min();
          changed = true;
        }
      }
    }
  }
  return changed;
}

unsigned SampleLattice::mask(glm::ivec3 cell) const {
  const size_t at = index(cell), y = size_t(corners_.x), z = y * size_t(corners_.y);
  const size_t offset[8] = {0, 1, y, y + 1, z, z + 1, z + y, z + y + 1};
  unsigned mask = 0;
  for (unsigned k = 0; k < 8; ++k) mask |= unsigned(value_[at + offset[k]] < 0.0f) << k;
  return mask;
}

glm::vec3 SampleLattice::crossing(glm::ivec3 a, glm::ivec3 b) const {
  if (!inside(a)) return crossing(b, a);
  const float in = value_[index(a)], out = value_[index(b)];
  const float share = std::isfinite(in) && std::isfinite(out) ? in / (in - out) : 0.5f;
  return glm::mix(position(a), position(b), share);
}

uint64_t SampleLattice::crossed_edges() const {
  uint64_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 step(0);
    step[axis] = 1;
    const size_t next = index(step);
    const glm::ivec3 end = corners_ - step;
    for (int z = 0; z < end.z; ++z) {
      for (int y = 0; y < end.y; ++y) {
        const size_t row = index({0, y, z});
        for (size_t at = row; at < row + size_t(end.x); ++at)
          count += (value_[at] < 0.0f) != (value_[at + next] < 0.0f);
      }
    }
  }
  return count;
}

}  // namespace lueur::builtin
