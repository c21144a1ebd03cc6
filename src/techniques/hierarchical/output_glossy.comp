// SPDX-License-Identifier: MIT
// The glossy light of level 0 -> the engine's resolution, times what its surfaces reflect.
// differs: Fresnel's share is that of the mirror direction for all of a lobe.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/brdf.h"
#include "shading/packing.h"
#include "techniques/hierarchical/upsample.glsl"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 2) uniform sampler2D depth;
layout(set = 0, binding = 3) uniform sampler2D normal;
layout(set = 0, binding = 4, rgba16f) uniform readonly image2D reflectance;
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D specular;
layout(set = 0, binding = 6, scalar) uniform Params { OutputParams value; } params;

void main() {
  const OutputParams p = params.value;
  if (any(greaterThan(ivec2(gl_GlobalInvocationID.xy), p.coarse_extent))) return;
  Corner corners[4];
  for (int i = 0; i < 4; ++i)
    corners[i] = load_corner(i, p.coarse_extent, p.coarse_scale, p.screen.ray_offset);

  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 pixel = fine_pixel(i);
    if (any(greaterThanEqual(uvec2(pixel), uvec2(p.extent)))) continue;
    const float d = texelFetch(depth, pixel, 0).r;
    const vec3 n = p.view_from_world * octahedral_decode(texelFetch(normal, pixel, 0).rg);
    const vec3 position =
        position_view(ray_through(p.screen, vec2(pixel) + 0.5), z_from_depth(p.screen, d));
    vec4 result = interpolate(corners, between_corners(i), position, n);
    const float cos_view = clamp(-dot(n, normalize(position)), 0.0, 1.0);
    result.rgb = min(result.rgb * reflected_share(imageLoad(reflectance, pixel), cos_view),
                     vec3(65504.0));
    result.a *= p.alpha_scale;
    imageStore(specular, pixel, d == p.screen.depth_of_nothing ? vec4(0.0) : result);
  }
}
