// SPDX-License-Identifier: MIT
// Point lights: a cube of six shadow maps around the light.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(set = 0, binding = 4) uniform samplerCubeShadow shadow_map;

#include "renderer/light.glsl"

// 3 x 3 bilinear comparisons around the direction to the point.
float shadow(vec3 position, vec3 n, vec3 to_light, float distance_m) {
  const LightParams p = params.value;
  const vec3 reach = abs(to_light);
  const float farthest = max(max(reach.x, reach.y), reach.z);
  const vec3 face = reach.x == farthest ? vec3(1, 0, 0)
                                        : (reach.y == farthest ? vec3(0, 1, 0) : vec3(0, 0, 1));
  const vec3 moved = shadow_position(position, n, face, p.texel_m * distance_m);
  const vec3 from_light = moved - p.position_world;
  const vec3 axis = abs(from_light);
  // The faces' reversed depth, near / z, with z along the face's axis.
  const float reference = p.shadow_near_m / max(max(axis.x, axis.y), axis.z);
  const vec3 side = normalize(
      cross(from_light, axis.y < 0.9 * length(from_light) ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  const vec3 up = normalize(cross(side, from_light));
  const float texel_m = p.texel_m * max(max(axis.x, axis.y), axis.z);
  float lit = 0.0;
  for (int i = 0; i < 9; ++i) {
    const vec2 offset = (vec2(i % 3, i / 3) - 1.0) * texel_m;
    lit += texture(shadow_map, vec4(from_light + side * offset.x + up * offset.y, reference));
  }
  return lit / 9.0;
}
