// SPDX-License-Identifier: MIT
// Level k of another source -> level k + 1, by downsample.comp's rule; the geometry is there
// already, and with it the foreshortening.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D foreshortened;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D source_out;
layout(push_constant, scalar) uniform Push { DownsampleSourceParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  // Outside of the image rgb is 0 (robustImageAccess).
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < 4; ++i) radiance += imageLoad(source, pixel * 2 + ivec2(i & 1, i >> 1)).rgb;
  imageStore(source_out, pixel, vec4(0.25 * radiance, imageLoad(foreshortened, pixel).a));
}
