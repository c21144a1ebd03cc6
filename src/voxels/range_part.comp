// SPDX-License-Identifier: MIT
// Least and greatest distance of what is visible, of each workgroup's pixels.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, scalar) buffer Parts { vec2 data[]; } parts;
layout(push_constant, scalar) uniform Push { RangePartParams p; };

shared vec2 shared_bounds[64];

void main() {
  const ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, kRowsPerThread);
  // 1 / z, greatest first: where nothing is, both stay 0.
  vec2 bounds = vec2(0.0);
  for (int k = 0; k < kRowsPerThread; ++k) {
    const ivec2 pixel = first + ivec2(0, k);
    if (any(greaterThanEqual(pixel, p.extent))) break;
    const float z = imageLoad(geometry, pixel).w;
    if (z > 0.0) bounds = vec2(max(bounds.x, 1.0 / z), max(bounds.y, z));
  }
  shared_bounds[gl_LocalInvocationIndex] = bounds;
  for (uint half_count = 32; half_count > 0; half_count /= 2) {
    barrier();
    if (gl_LocalInvocationIndex < half_count)
      shared_bounds[gl_LocalInvocationIndex] =
          max(shared_bounds[gl_LocalInvocationIndex],
              shared_bounds[gl_LocalInvocationIndex + half_count]);
  }
  if (gl_LocalInvocationIndex == 0)
    parts.data[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = shared_bounds[0];
}
