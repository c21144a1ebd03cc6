// SPDX-License-Identifier: MIT
// Where the slices lie: around what is visible.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"
#include "voxels/slices.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, scalar) readonly buffer Parts { vec2 data[]; } parts;
layout(set = 0, binding = 1, scalar) buffer Range { VoxelRange value; } range;
layout(push_constant, scalar) uniform Push { RangeParams p; };

shared vec2 shared_bounds[64];

void main() {
  vec2 bounds = vec2(0.0);
  for (uint i = gl_LocalInvocationIndex; i < p.parts; i += 64) bounds = max(bounds, parts.data[i]);
  shared_bounds[gl_LocalInvocationIndex] = bounds;
  barrier();
  if (gl_LocalInvocationIndex != 0) return;
  for (uint i = 1; i < 64; ++i) bounds = max(bounds, shared_bounds[i]);

  // Outward to multiples of a part of the depth there is, so that slices stay in place while a
  // camera moves a little; near the eye to powers of 2^(1/4), as 0 is no depth. Where nothing is
  // visible, any range does.
  float z_near = 1.0;
  float z_far = 2.0;
  if (bounds.y > 0.0) {
    const float nearest = 1.0 / bounds.x;
    const float farthest = bounds.y;
    const float unit =
        exp2(floor(log2(max(farthest - nearest, 1e-3 * farthest)))) / float(kRangeParts);
    z_near = max(exp2(floor(4.0 * log2(nearest)) / 4.0), floor(nearest / unit) * unit);
    z_far = (floor(farthest / unit) + 1.0) * unit;
  }
  range.value = VoxelRange(z_near, float(p.slices) / (z_far - z_near), p.slices);
}
