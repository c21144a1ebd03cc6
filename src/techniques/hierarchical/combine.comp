// SPDX-License-Identifier: MIT
// B_k = I_k + up(B_(k+1)), coarse to fine: HSSIL 3.2, "continuous combination".
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/upsample.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D fine_geometry;
layout(set = 0, binding = 3, rgba16f) uniform readonly image2D own;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D combined;
layout(push_constant, scalar) uniform Push { UpsampleParams p; };

void main() {
  if (any(greaterThan(ivec2(gl_GlobalInvocationID.xy), p.coarse_extent))) return;
  Corner corners[4];
  for (int i = 0; i < 4; ++i)
    corners[i] = load_corner(i, p.coarse_extent, p.coarse_scale, p.screen.ray_offset);

  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 pixel = fine_pixel(i);
    if (any(greaterThanEqual(uvec2(pixel), uvec2(p.extent)))) continue;
    const vec4 g = imageLoad(fine_geometry, pixel);
    vec4 sum = vec4(0.0);
    if (g.w > 0.0) {
      const vec2 ray = ray_through(p.screen, vec2(pixel) + 0.5);
      sum = interpolate(corners, between_corners(i), position_view(ray, g.w), g.xyz);
    }
    if (p.own_weight > 0.0) sum += imageLoad(own, pixel);
    imageStore(combined, pixel, min(sum, vec4(65504.0)));
  }
}
