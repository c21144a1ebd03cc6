// SPDX-License-Identifier: MIT
// What the passes get from the CPU.
#ifndef LUEUR_VOXELS_PARAMS_H
#define LUEUR_VOXELS_PARAMS_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// Rows of pixels that one thread of range_part.comp looks at.
const int kRowsPerThread = 16;
// The range of depths is rounded outwards to this part of its own power of two.
const int kRangeParts = 8;
// How far from a pixel's centre its column still belongs to a shell: to the pixel's edges.
const float kShellReachPx = 0.5f;
// Triangles of a workgroup of toggle.comp.
const uint kChunkTriangles = 64u;

// One TriangleRange. (dot(row_x, p), dot(row_y, p), dot(row_z, p)) with p = (position, 1) is a
// vertex in the homogeneous coordinates of triangle.glsl.
struct RangeData {
  vec4 row_x;
  vec4 row_y;
  vec4 row_z;
  uint first_index;
  int vertex_offset;
  uint triangle_count;
  float thickness_m;  // of the solid that it bounds, 0: none
};

// Where the vertices of a TriangleBatch are.
struct VertexPlace {
  uint first_float;
  uint stride_floats;
};

// Up to kChunkTriangles consecutive triangles of a range: the work of one workgroup.
struct Chunk {
  uint range;
  uint first_triangle;
};

struct RangePartParams {
  ivec2 extent;  // of the geometry image
};

struct RangeParams {
  uint parts;
  uint slices;
};

struct ToggleParams {
  ivec2 extent;  // pixels of level 0
  VertexPlace place;
  uint chunks;
};

struct FillParams {
  ivec2 extent;  // pixels
  uint words;    // a column
};

struct LevelParams {
  ivec2 fine_extent;  // pixels
  ivec2 extent;
  uint words;
};

struct RasterParams {
  ivec2 extent;  // pixels
  VertexPlace place;
};

struct RasterDraw {
  RangeData range;
  uint is_shell;
};

struct RasterCopyParams {
  ivec2 extent;  // pixels
  uint words;
};

LUEUR_NAMESPACE_END

#endif
