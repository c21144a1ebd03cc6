// SPDX-License-Identifier: MIT
// LCM (3), glossy: what the texels of one map give through the surfaces' lobes.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/blinn.h"
#include "cube_maps/equations.h"
#include "shading/cosine_lobe.h"
#include "techniques/cube_map/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D object;
layout(set = 0, binding = 3, scalar) readonly buffer MapOfObject { uint data[]; } map_of_object;
layout(set = 0, binding = 4, scalar) readonly buffer Texels { TexelLight data[]; } texels;
layout(set = 0, binding = 5, rgba32f) uniform image2D sum;  // light times shares, shares
layout(set = 0, binding = 6, scalar) uniform Params { GatherParams value; } params;
layout(set = 0, binding = 7) uniform sampler2D reflectance;
layout(set = 0, binding = 8, scalar) readonly buffer Lobes { CosineLobeData data[]; } lobes;

#include "shading/lobe.glsl"
#include "techniques/cube_map/receivers.glsl"

void main() {
  const GatherParams p = params.value;
  Receivers r;
  if (!load_receivers(p, r)) return;
  vec3 to_eye[pixels_per_thread];
  vec3 reflected[pixels_per_thread];
  Lobe lobe[pixels_per_thread];
  vec3 light[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = min(first_pixel(p) + ivec2(0, k), p.camera.extent - 1);
    const vec4 code = texelFetch(reflectance, pixel, 0);
    to_eye[k] = -normalize(r.surface[k].position);
    const float cos_view = clamp(dot(r.surface[k].normal, to_eye[k]), 0.0, 1.0);
    reflected[k] = reflected_share(code, cos_view);
    lobe[k] = lobe_of(code.a < 0.0 ? 1.0 - code.a : code.a);
    light[k] = vec3(0.0);
  }
  for (uint i = p.first_texel; i < p.end_texel; ++i) {
    const TexelLight t = texels.data[i];
    for (uint k = 0; k < pixels_per_thread; ++k) {
      const vec3 way = t.position - r.surface[k].position;
      const float r2 = dot(way, way) + 1.0e-30;
      const vec3 to_light = way * inversesqrt(r2);
      const float facing = dot(r.surface[k].normal, to_light);
      if (facing <= 0.0) continue;
      const vec3 n = r.surface[k].normal;
      const float solid_angle_sr = kPi * localized_share(t, r2);
      const float brdf = p.blinn_exponent > 0.0
                             ? blinn_brdf(p.blinn_exponent, n, to_light, to_eye[k])
                             : lobe_brdf(lobe[k], n, to_light, to_eye[k], solid_angle_sr);
      light[k] += t.radiance * (brdf * facing * solid_angle_sr);
    }
  }
  for (uint k = 0; k < pixels_per_thread; ++k)
    add_to_sum(first_pixel(p) + ivec2(0, k), light[k] * reflected[k], r.share[k], p.first_texel == 0);
}
