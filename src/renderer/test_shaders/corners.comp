// SPDX-License-Identifier: MIT
// The corners of a range of triangles, in world space, one a pixel.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/test_shaders/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, scalar) readonly buffer Vertices { float data[]; } vertices;
layout(set = 0, binding = 1, scalar) readonly buffer Indices { uint data[]; } indices;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D geometry;
layout(push_constant, scalar) uniform Push { CornerParams p; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= p.index_count) return;
  const int vertex = int(indices.data[p.first_index + i]) + p.vertex_offset;
  const uint at = p.first_float + uint(vertex) * p.stride_floats;
  const vec3 position = vec3(vertices.data[at], vertices.data[at + 1], vertices.data[at + 2]);
  imageStore(geometry, ivec2(i, 0), p.world_from_object * vec4(position, 1.0));
}
