// SPDX-License-Identifier: MIT
// The sum of two lights of level 0, or the larger one of each channel. Alpha, which depends on
// geometry alone, is the first one's.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/params.h"

layout(constant_id = 0) const uint take_larger = 0;
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D a;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D b;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D sum;
layout(push_constant, scalar) uniform Push { AddParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 first = imageLoad(a, pixel);
  const vec3 second = imageLoad(b, pixel).rgb;
  const vec3 both = take_larger == 1 ? max(first.rgb, second) : first.rgb + second;
  imageStore(sum, pixel, vec4(min(both, vec3(65504.0)), first.a));
}
