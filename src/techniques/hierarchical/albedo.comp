// SPDX-License-Identifier: MIT
// The mean albedo that each pixel of level 0 passes on light with.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/params.h"

layout(constant_id = 0) const int factor = 2;
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D albedo;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2D mean;
layout(push_constant, scalar) uniform Push { AlbedoParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 child = min(pixel * factor + ivec2(i % factor, i / factor), p.full_extent - 1);
    sum += imageLoad(albedo, child).rgb;
  }
  imageStore(mean, pixel, vec4(sum / float(factor * factor), 1.0));
}
