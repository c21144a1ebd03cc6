// SPDX-License-Identifier: MIT
// Normals and tangents that a file leaves out.
#pragma once

#include <cstdint>
#include <span>

#include "scene/scene.h"

namespace lueur {

// Gives the vertices of each triangle its face's normal; no two triangles may share a vertex.
// Degenerate triangles get +y.
void make_flat_normals(std::span<Vertex> vertices);

// Normalizes the normals. Zero ones become the area-weighted mean of their triangles' normals, or
// +y where that vanishes too. `indices` holds triangles of `vertices`. Returns how many were zero.
uint64_t repair_normals(std::span<Vertex> vertices, std::span<const uint32_t> indices);

// Makes tangents whose w is 0 from positions, texture coordinates and unit normals: along +u,
// summed over each vertex' triangles, w the handedness; where the coordinates give no direction,
// any. Then all tangents are unit length, orthogonal to the normal, and w is ±1.
void make_tangents(std::span<Vertex> vertices, std::span<const uint32_t> indices);

}  // namespace lueur
