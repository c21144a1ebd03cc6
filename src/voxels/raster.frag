// SPDX-License-Identifier: MIT
// A pixel's column of voxels as up to four targets, to be combined by XOR or OR.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"
#include "voxels/slices.h"

layout(set = 0, binding = 2, scalar) readonly buffer Range { VoxelRange value; } range;
layout(push_constant, scalar) uniform Push { RasterDraw p; };
layout(location = 0) flat in vec2 plane_at_px;
layout(location = 1) flat in float plane_inverse_z;
layout(location = 2) flat in vec2 plane_gradient;
layout(location = 3) flat in vec2 plane_bounds;
layout(location = 0) out uvec4 bits_0;
layout(location = 1) out uvec4 bits_1;
layout(location = 2) out uvec4 bits_2;
layout(location = 3) out uvec4 bits_3;

#include "voxels/plane.glsl"

uvec4 words_from(int word, ivec2 slices) {
  return uvec4(slice_mask(word, slices.x, slices.y), slice_mask(word + 1, slices.x, slices.y),
               slice_mask(word + 2, slices.x, slices.y), slice_mask(word + 3, slices.x, slices.y));
}

void main() {
  const Plane plane = Plane(plane_at_px, plane_inverse_z, plane_gradient, plane_bounds);
  ivec2 slices = slices_of(range.value, plane, gl_FragCoord.xy,
                           p.range.thickness_m == 0.0 ? kShellReachPx : 0.0);
  if (p.is_shell == 0) slices.y = int(range.value.slices) - 1;  // and all behind
  bits_0 = words_from(0, slices);
  bits_1 = words_from(4, slices);
  bits_2 = words_from(8, slices);
  bits_3 = words_from(12, slices);
}
