// SPDX-License-Identifier: MIT
// LCM 5: radiance and distance are both averaged.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D finer;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D texels;
layout(push_constant, scalar) uniform Push { AverageParams p; };

void main() {
  const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, p.extent))) return;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < p.factor; ++y)
    for (int x = 0; x < p.factor; ++x) sum += imageLoad(finer, texel * p.factor + ivec2(x, y));
  imageStore(texels, p.corner + texel, sum / float(p.factor * p.factor));
}
