// SPDX-License-Identifier: MIT
// 3 x 3 joint bilateral box filter of light, and of what its alpha holds. Nine neighbours have nine
// interleaved sample patterns (see spiral_start), so on a smooth surface their plain mean has no
// pattern left. Again with a step of three pixels, it is one of 9 x 9.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/joint_filter.h"

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

  // Outside of the image z loads as 0 (robustImageAccess), like where there is no surface.
  vec4 g[9];
  vec4 l[9];
  for (int i = 0; i < 9; ++i) {
    const ivec2 q = pixel + p.step_px * (ivec2(i % 3, i / 3) - 1);
    g[i] = imageLoad(geometry, q);
    l[i] = imageLoad(light, q);
  }
  vec4 sum = l[4];
  float weights = 1.0;
  for (int i = 0; i < 9; ++i) {
    const vec2 centre = vec2(pixel + p.step_px * (ivec2(i % 3, i / 3) - 1)) + 0.5;
    const vec3 other = position_view(ray_through(p.screen, centre), g[i].w);
    const float weight =
        i == 4 || own.w == 0.0 || g[i].w == 0.0
            ? 0.0
            : bilateral_weight(position, own.xyz, other, g[i].xyz, kFlatness);
    sum += weight * l[i];
    weights += weight;
  }
  imageStore(filtered, pixel, sum / weights);
}
