// SPDX-License-Identifier: MIT
// Joint bilateral interpolation of a coarse level's light: `up` of HSSIL 3.2. Together with
// filter.comp it makes the paper's 3 x 3 kernel, spread over the level's texels without steps.
// Expects `geometry` and `light` of the coarse level.
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

// `coarse_px`: the fine pixel's centre in pixels of the coarse level.
vec4 upsample(vec2 coarse_px, ivec2 coarse_extent, vec2 coarse_scale, vec2 ray_offset,
              vec3 position, vec3 normal) {
  const vec2 corner = coarse_px - 0.5;
  const ivec2 base = ivec2(floor(corner));
  const vec2 f = corner - vec2(base);
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    const ivec2 step = ivec2(i & 1, i >> 1);
    const ivec2 q = clamp(base + step, ivec2(0), coarse_extent - 1);
    const vec4 g = imageLoad(geometry, q);
    const vec2 bilinear = mix(1.0 - f, f, vec2(step));
    const vec3 other =
        position_view((vec2(q) + 0.5) * coarse_scale + ray_offset, g.w);
    // Where no coarse pixel is of the same surface, the plain interpolation remains.
    float weight = 1.0e-4;
    if (g.w > 0.0) weight += bilateral_weight(position, normal, other, g.xyz, kFlatness);
    weight *= bilinear.x * bilinear.y + 1.0e-4;
    sum += weight * imageLoad(light, q);
    weights += weight;
  }
  return sum / weights;
}
