// SPDX-License-Identifier: MIT
// The classical environment map: one look-up a pixel, whatever its place.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/cosine_lobe.h"
#include "shading/packing.h"
#include "techniques/cube_map/panorama.glsl"

layout(constant_id = 2) const uint glossy = 0;
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D object;
layout(set = 0, binding = 3, scalar) readonly buffer MapOfObject { uint data[]; } map_of_object;
layout(set = 0, binding = 4, rgba16f) uniform readonly image2D panoramas;
layout(set = 0, binding = 5, rgba32f) uniform image2D sum;  // light times shares, shares
layout(set = 0, binding = 6, scalar) uniform Params { GatherParams value; } params;
layout(set = 0, binding = 7) uniform sampler2D reflectance;
layout(set = 0, binding = 8, scalar) readonly buffer Lobes { CosineLobeData data[]; } lobes;

#include "shading/lobe.glsl"
#include "techniques/cube_map/receivers.glsl"

vec3 panorama_at(uint map, int index, vec3 direction_world) {
  const vec2 at =
      (octahedral_encode(direction_world) * 0.5 + 0.5) * float(kPanoramaSide) - 0.5;
  const ivec2 corner = ivec2(floor(at));
  const vec2 part = at - vec2(corner);
  vec3 light = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    const ivec2 side = ivec2(i & 1, i >> 1);
    const vec2 share = mix(1.0 - part, part, vec2(side));
    const ivec2 texel = unfolded(corner + side);
    light += share.x * share.y *
             imageLoad(panoramas, ivec2(index, map) * kPanoramaSide + texel).rgb;
  }
  return light;
}

vec3 reflected_light(GatherParams p, Surface s, ivec2 pixel) {
  const vec4 code = texelFetch(reflectance, pixel, 0);
  const vec3 to_eye = -normalize(s.position);
  Lobe lobe = lobe_of(code.a < 0.0 ? 1.0 - code.a : code.a);
  vec3 axis = cosine_lobe_axis(lobe.c_xy, lobe.c_z, s.normal, to_eye);
  float alpha = lobe.is_ggx ? lobe.alpha : alpha_of_exponent(lobe.exponent);
  if (p.blinn_exponent > 0.0) {
    alpha = alpha_of_exponent(p.blinn_exponent);
    axis = reflect(-to_eye, s.normal);
  }
  const float roughness = sqrt(min(alpha, 1.0));
  const float level = roughness * float(kRoughnesses - 1);
  const int finer = min(int(level), kRoughnesses - 2);
  const vec3 world = axis * p.camera.view_from_world;
  const vec3 light = mix(panorama_at(p.share.map, 1 + finer, world),
                         panorama_at(p.share.map, 2 + finer, world), level - float(finer));
  const vec3 share = reflected_share(code, clamp(dot(s.normal, to_eye), 0.0, 1.0));
  // What GGX loses between facets: Karis' fit of its albedo for a Fresnel reflectance of 1.
  const float albedo = lobe.is_ggx && p.blinn_exponent == 0.0 ? 1.0 - 0.55 * roughness : 1.0;
  return light * share * albedo;
}

void main() {
  const GatherParams p = params.value;
  Receivers r;
  if (!load_receivers(p, r)) return;
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first_pixel(p) + ivec2(0, k);
    if (r.share[k] == 0.0) continue;
    const Surface s = r.surface[k];
    const vec3 light = glossy == 1
                           ? reflected_light(p, s, pixel)
                           : panorama_at(p.share.map, 0, s.normal * p.camera.view_from_world);
    add_to_sum(pixel, light, r.share[k], true);
  }
}
