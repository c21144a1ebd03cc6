// SPDX-License-Identifier: MIT
// BZB figure 6a: triangles near the view, large ones in parts.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "surfels/params.h"

layout(local_size_x = 64) in;  // kSurfelChunk
layout(set = 0, binding = 0, scalar) readonly buffer Vertices { float data[]; } vertices;
layout(set = 0, binding = 1, scalar) readonly buffer Indices { uint data[]; } indices;
layout(set = 0, binding = 2, scalar) readonly buffer Ranges { SurfelRange data[]; } ranges;
layout(set = 0, binding = 3, scalar) readonly buffer Chunks { SurfelChunk data[]; } chunks;
layout(set = 0, binding = 4, scalar) buffer Parts { uint count; TrianglePart data[]; } list;
layout(push_constant, scalar) uniform Push { SurfelizeParams p; };

#include "surfels/triangle.glsl"

void main() {
  const uint chunk_index = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (chunk_index >= p.chunks) return;
  const SurfelChunk chunk = chunks.data[chunk_index];
  const SurfelRange range = ranges.data[chunk.range];
  const uint triangle = chunk.first_triangle + gl_LocalInvocationIndex;
  if (triangle >= range.triangle_count) return;
  const mat3 t = triangle_at(range, triangle);
  const vec4 ball = ball_around(t);
  if (!is_near_view(ball.xyz, ball.w)) return;
  const float longest = sqrt(max(max(dot(t[1] - t[0], t[1] - t[0]), dot(t[2] - t[1], t[2] - t[1])),
                                 dot(t[0] - t[2], t[0] - t[2])));
  const uint parts = parts_of(longest, max(length(nearest_of(t)), p.least_distance_m));
  const uint first = atomicAdd(list.count, parts * parts);
  for (uint i = 0; i < parts * parts && first + i < p.parts_capacity; ++i)
    list.data[first + i] = TrianglePart(chunk.range, triangle, parts, i);
}
