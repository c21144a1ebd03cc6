// SPDX-License-Identifier: MIT
// Copies what a sampler sees, plus a number.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "frame/test_shaders/params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D from;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D to;
layout(push_constant, scalar) uniform Push { CopyParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  imageStore(to, pixel, texelFetch(from, pixel, 0) + p.add);
}
