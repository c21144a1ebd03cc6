// SPDX-License-Identifier: MIT
// Copies into an image that holds light and into one whose name allows negative values.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "frame/test_shaders/params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D from;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D light;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D normal;
layout(push_constant, scalar) uniform Push { CopyParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  imageStore(light, pixel, texelFetch(from, pixel, 0));
  imageStore(normal, pixel, texelFetch(from, pixel, 0));
}
