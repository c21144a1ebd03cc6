// SPDX-License-Identifier: MIT
// The finest level's light -> the engine's resolution, along its own depth and normals.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/packing.h"
#include "techniques/hierarchical/upsample.glsl"

// One row of pixels a workgroup: texel fetches of whole rows take 0.6 of the time that squares take
// on a CPU.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 2) uniform sampler2D depth;
layout(set = 0, binding = 3) uniform sampler2D normal;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D diffuse;
layout(set = 0, binding = 5, scalar) uniform Params { OutputParams value; } params;

void main() {
  const OutputParams p = params.value;
  if (any(greaterThan(ivec2(gl_GlobalInvocationID.xy), p.coarse_extent))) return;
  Corner corners[4];
  for (int i = 0; i < 4; ++i)
    corners[i] = load_corner(i, p.coarse_extent, p.coarse_scale, p.screen.ray_offset);

  float d[factor * factor];
  vec2 n[factor * factor];
  for (int i = 0; i < factor * factor; ++i) {
    // The image's own edge stands in for what lies outside, and is not written again.
    const ivec2 pixel = clamp(fine_pixel(i), ivec2(0), p.extent - 1);
    d[i] = texelFetch(depth, pixel, 0).r;
    n[i] = texelFetch(normal, pixel, 0).rg;
  }
  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 pixel = fine_pixel(i);
    const vec2 ray = ray_through(p.screen, vec2(pixel) + 0.5);
    vec4 result = interpolate(corners, between_corners(i),
                              position_view(ray, z_from_depth(p.screen, d[i])),
                              p.view_from_world * octahedral_decode(n[i]));
    result.a *= p.alpha_scale;
    if (d[i] == p.screen.depth_of_nothing) result = vec4(0.0);
    if (all(lessThan(uvec2(pixel), uvec2(p.extent)))) imageStore(diffuse, pixel, result);
  }
}
