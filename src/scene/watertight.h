// SPDX-License-Identifier: MIT
// Which of a mesh's triangles bound a solid, so that there is an inside.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace lueur {

struct Watertightness {
  // Of each triangle of Mesh::indices: whether its component is closed. Triangles with two corners
  // at one place cover nothing and never spoil it.
  std::vector<bool> is_closed;
  // Of each triangle: how thick its component is, twice the volume over the area. 0: it is open, or
  // bounds nothing.
  std::vector<float> thickness_m;
  uint64_t closed_triangles = 0;
  uint64_t open_triangles = 0;
  uint64_t open_edges = 0;  // of the first component that is open
};

// How far apart vertices may be and still count as one, as a share of the mesh's greatest
// coordinate: some roundings of a float. Solids can be cut into pieces whose common vertices were
// computed twice.
inline constexpr float kWeldDistance = 1.0f / (1 << 20);

// Vertices at one position count as one, whatever else they hold. Triangles that share an edge are
// of one component. It is closed if each of its edges runs in one direction as often as in the
// other, which is so for a manifold without a rim whose faces all look outwards (or all inwards).
// Of the mesh as it is stored: skins and morph targets that move vertices apart are not seen.
// Positions must be finite.
Watertightness watertightness(const Mesh& mesh);

}  // namespace lueur
