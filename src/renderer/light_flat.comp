// SPDX-License-Identifier: MIT
// Spot and directional lights: one flat shadow map.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(set = 0, binding = 4) uniform sampler2DShadow shadow_map;

#include "renderer/light.glsl"

// 3 x 3 bilinear comparisons, two texels apart at most: a soft edge about three texels wide.
float shadow(vec3 position, vec3 n, vec3 to_light, float distance_m) {
  const LightParams p = params.value;
  const float texel_m =
      p.kind == kLightDirectional ? p.texel_m
                                  : p.texel_m * dot(-to_light, p.direction_world) * distance_m;
  const vec4 clip = p.shadow_from_world *
                    vec4(shadow_position(position, n, p.direction_world, texel_m), 1.0);
  if (clip.w <= 0.0) return 0.0;
  const vec3 ndc = clip.xyz / clip.w;
  const vec2 uv = ndc.xy * 0.5 + 0.5;
  const vec2 texel = 1.0 / vec2(textureSize(shadow_map, 0));
  float lit = 0.0;
  for (int i = 0; i < 9; ++i)
    lit += textureLod(shadow_map, vec3(uv + (vec2(i % 3, i / 3) - 1.0) * texel, ndc.z), 0.0);
  return lit / 9.0;
}
