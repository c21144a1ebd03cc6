// SPDX-License-Identifier: MIT
// Nothing was gathered yet.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/cube_map/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba32f) uniform writeonly image2D sum;
layout(push_constant, scalar) uniform Push { BeginParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  imageStore(sum, pixel, vec4(0.0));
}
