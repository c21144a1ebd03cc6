// SPDX-License-Identifier: MIT
// B_k = I_k + up(B_(k+1)), coarse to fine: HSSIL 3.2, "continuous combination".
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D light;

#include "techniques/hierarchical/upsample.glsl"

layout(set = 0, binding = 2, rgba32f) uniform readonly image2D fine_geometry;
layout(set = 0, binding = 3, rgba16f) uniform readonly image2D own;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D combined;
layout(push_constant, scalar) uniform Push { UpsampleParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 g = imageLoad(fine_geometry, pixel);
  const vec2 centre = vec2(pixel) + 0.5;
  vec4 sum = vec4(0.0);
  if (g.w > 0.0)
    sum = upsample(centre * 0.5, p.coarse_extent, p.coarse_scale, p.screen.ray_offset,
                   position_view(ray_through(p.screen, centre), g.w), g.xyz);
  if (p.own_weight > 0.0) sum += imageLoad(own, pixel);
  imageStore(combined, pixel, min(sum, vec4(65504.0)));
}
