// SPDX-License-Identifier: MIT
// The scene's triangles as an engine has them on the device, described much as Vulkan describes
// them for acceleration structures. For voxels, surfels and volumes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lueur/buffer.h"

namespace lueur {

// Consecutive triangles of one instance of a mesh.
struct TriangleRange {
  uint32_t first_index = 0;
  uint32_t index_count = 0;   // a multiple of 3
  int32_t vertex_offset = 0;  // added to each index
  // Whether the triangles bound a solid: each edge is shared by as many triangles of one direction
  // as of the other. What is not closed counts as a thin shell.
  bool closed = false;
  // How thick that solid is: twice its volume over its area, in the units of `vertices`. A solid
  // that is thinner than a grid can show, such as cloth, counts as a shell there. 0: not told, and
  // never too thin.
  float thickness = 0.0f;
  std::array<float, 16> world_from_object{};  // column-major, for column vectors
};

// All ranges that share their buffers. Vertex i's position are the three floats at
// `first_float + i * stride_floats` of `vertices`.
struct TriangleBatch {
  BufferRef vertices;  // storage buffer of floats
  BufferRef indices;   // storage buffer of uint32
  uint32_t first_float = 0;
  uint32_t stride_floats = 3;
  std::vector<TriangleRange> ranges;
};

}  // namespace lueur
