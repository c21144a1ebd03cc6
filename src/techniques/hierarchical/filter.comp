// SPDX-License-Identifier: MIT
// 3 x 3 joint bilateral box filter within one level. Nine neighbours hold nine interleaved sample
// patterns (see spiral_start), so on a smooth surface their plain mean has no pattern left.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D light;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D filtered;
layout(push_constant, scalar) uniform Push { FilterParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 own = imageLoad(geometry, pixel);
  const vec3 position = position_view(ray_through(p.screen, vec2(pixel) + 0.5), own.w);

  vec4 sum = imageLoad(light, pixel);
  float weights = 1.0;
  for (int i = 0; i < 9; ++i) {
    const ivec2 q = pixel + ivec2(i % 3, i / 3) - 1;
    if (i == 4 || own.w == 0.0 || any(lessThan(q, ivec2(0))) ||
        any(greaterThanEqual(q, p.extent)))
      continue;
    const vec4 g = imageLoad(geometry, q);
    if (g.w == 0.0) continue;
    const vec3 other = position_view(ray_through(p.screen, vec2(q) + 0.5), g.w);
    const float weight = bilateral_weight(position, own.xyz, other, g.xyz, kFlatness);
    sum += weight * imageLoad(light, q);
    weights += weight;
  }
  imageStore(filtered, pixel, sum / weights);
}
