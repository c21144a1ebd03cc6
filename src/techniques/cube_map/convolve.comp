// SPDX-License-Identifier: MIT
// The classical environment map: light of a cube map as its centre gets it, for each direction
// beforehand.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/equations.h"
#include "cube_maps/params.h"
#include "shading/brdf.h"
#include "shading/packing.h"
#include "techniques/cube_map/panorama.glsl"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D atlas;
layout(set = 0, binding = 1, scalar) readonly buffer Faces { mat4 world_from_face[]; } faces;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D panoramas;
layout(push_constant, scalar) uniform Push { PlaceParams p; };

// For which light along `to_light` counts how much, of a mirror's direction and a roughness.
// differs: as if it were looked at along the normal, which is what makes a table of it.
float lobe_weight(vec3 mirrored, vec3 to_light, float roughness) {
  const float cosine = dot(mirrored, to_light);
  if (cosine <= 0.0) return 0.0;
  const float cos_half = sqrt(0.5 + 0.5 * cosine);
  return ggx_brdf(vec3(1.0), 1.0, roughness, cosine, 1.0, cos_half, 1.0).r * cosine;
}

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= kPanoramaSide * (1 + kRoughnesses) || at.y >= kPanoramaSide) return;
  const int lobe = at.x / kPanoramaSide - 1;  // -1: diffuse
  const vec3 direction = direction_of(ivec2(at.x % kPanoramaSide, at.y));
  // No narrower than what the texels can show.
  const float roughness = max(float(lobe) / float(kRoughnesses - 1), 1.0 / sqrt(float(p.side)));
  vec3 light = vec3(0.0);
  float weights = 0.0;
  for (int face = 0; face < 6; ++face) {
    const mat3 to_world = mat3(faces.world_from_face[p.map * 6 + face]);
    for (int i = 0; i < p.side * p.side; ++i) {
      const ivec2 texel = ivec2(i % p.side, i / p.side);
      const vec3 ray = vec3(ray_through(p.screen, vec2(texel) + 0.5), -1.0);
      const float ray_length = length(ray);
      const float over_pi = texel_solid_angle(float(p.side), ray_length) / kPi;
      const vec3 to_light = to_world * ray / ray_length;
      const float weight =
          over_pi * (lobe < 0 ? max(dot(direction, to_light), 0.0)
                              : lobe_weight(direction, to_light, roughness));
      light += weight * imageLoad(atlas, ivec2(face, p.map) * p.side + texel).rgb;
      weights += weight;
    }
  }
  if (lobe >= 0) light /= max(weights, 1.0e-20);
  imageStore(panoramas, at + ivec2(0, p.map * kPanoramaSide), vec4(light, 1.0));
}
