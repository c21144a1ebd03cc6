// SPDX-License-Identifier: MIT
// The finest level's light -> the engine's resolution, along its own depth and normals.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/packing.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D light;

#include "techniques/hierarchical/upsample.glsl"

layout(set = 0, binding = 2) uniform sampler2D depth;
layout(set = 0, binding = 3) uniform sampler2D normal;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D diffuse;
layout(set = 0, binding = 5, scalar) uniform Params { OutputParams value; } params;

void main() {
  const OutputParams p = params.value;
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const float d = texelFetch(depth, pixel, 0).r;
  vec4 result = vec4(0.0);
  if (d != p.screen.depth_of_nothing) {
    const vec2 centre = vec2(pixel) + 0.5;
    if (p.factor == 1) {
      result = imageLoad(light, pixel);
    } else {
      const vec3 n = p.view_from_world * octahedral_decode(texelFetch(normal, pixel, 0).rg);
      const float z = z_from_depth(p.screen, d);
      result = upsample(centre / float(p.factor), p.coarse_extent, p.coarse_scale,
                        p.screen.ray_offset, position_view(ray_through(p.screen, centre), z), n);
    }
    result.a *= p.alpha_scale;
  }
  imageStore(diffuse, pixel, result);
}
