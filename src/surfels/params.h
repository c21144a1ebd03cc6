// SPDX-License-Identifier: MIT
// What the passes get from the CPU, and what they give.
#ifndef LUEUR_SURFELS_PARAMS_H
#define LUEUR_SURFELS_PARAMS_H

#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

// A disc, in the camera's view space.
struct Surfel {
  vec3 position;
  float radius_m;
  vec3 normal;
  uint range;  // of its batch
};

// One TriangleRange.
struct SurfelRange {
  mat4 view_from_object;
  uint first_index;
  int vertex_offset;
  uint triangle_count;
};

// Up to kSurfelChunk consecutive triangles of a range: the work of one workgroup.
struct SurfelChunk {
  uint range;
  uint first_triangle;
};
const uint kSurfelChunk = 64u;

// Part `part` of parts x parts of a triangle.
struct TrianglePart {
  uint range;
  uint triangle;
  uint parts;
  uint part;
};

struct SurfelizeParams {
  Screen screen;
  vec2 corner_px;  // where the picture ends; it begins at 0
  float pixel;     // side at distance 1
  float radius_px;
  float margin_m;
  float least_distance_m;
  uint first_float;  // of the vertices, see TriangleBatch
  uint stride_floats;
  uint chunks;
  uint parts_capacity;
  uint surfels_capacity;
};

LUEUR_NAMESPACE_END

#endif
