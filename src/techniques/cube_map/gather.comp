// SPDX-License-Identifier: MIT
// LCM (3), diffuse: what the texels of one map give to the pixels that take of it.
//   E / pi = sum over texels of  L cos+(theta) dw* / pi
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/equations.h"
#include "techniques/cube_map/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D object;
layout(set = 0, binding = 3, scalar) readonly buffer MapOfObject { uint data[]; } map_of_object;
layout(set = 0, binding = 4, scalar) readonly buffer Texels { TexelLight data[]; } texels;
layout(set = 0, binding = 5, rgba32f) uniform image2D sum;  // light times shares, shares
layout(set = 0, binding = 6, scalar) uniform Params { GatherParams value; } params;

#include "techniques/cube_map/receivers.glsl"

void main() {
  const GatherParams p = params.value;
  Receivers r;
  if (!load_receivers(p, r)) return;
  vec3 light[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) light[k] = vec3(0.0);
  for (uint i = p.first_texel; i < p.end_texel; ++i) {
    const TexelLight t = texels.data[i];
    for (uint k = 0; k < pixels_per_thread; ++k) {
      const vec3 way = t.position - r.surface[k].position;
      const float r2 = dot(way, way) + 1.0e-30;
      const float facing = max(dot(r.surface[k].normal, way), 0.0);
      light[k] += t.radiance * (facing * inversesqrt(r2) * localized_share(t, r2));
    }
  }
  for (uint k = 0; k < pixels_per_thread; ++k)
    add_to_sum(first_pixel(p) + ivec2(0, k), light[k], r.share[k], p.first_texel == 0);
}
