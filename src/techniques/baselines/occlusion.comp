// SPDX-License-Identifier: MIT
// The alpha of gathered light as an image of its own.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/baselines/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D light;
layout(set = 0, binding = 1, r16f) uniform writeonly image2D occlusion;
layout(push_constant, scalar) uniform Push { OcclusionParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  imageStore(occlusion, pixel, vec4(imageLoad(light, pixel).a));
}
