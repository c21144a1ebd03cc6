// SPDX-License-Identifier: MIT
// LCM 4: the texels of a map as the surfaces that they show, seen from the camera.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/equations.h"
#include "cube_maps/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D atlas;
layout(set = 0, binding = 1, scalar) readonly buffer Faces { mat4 camera_from_face[]; } faces;
layout(set = 0, binding = 2, scalar) writeonly buffer Texels { TexelLight data[]; } texels;
layout(push_constant, scalar) uniform Push { PlaceParams p; };

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= p.texels) return;
  const int a_face = p.side * p.side;
  const int face = int(index) / a_face;
  const ivec2 texel = ivec2(int(index) % p.side, int(index) % a_face / p.side);
  const vec4 seen = imageLoad(atlas, ivec2(face, p.map) * p.side + texel);

  const vec3 ray = vec3(ray_through(p.screen, vec2(texel) + 0.5), -1.0);
  const float ray_length = length(ray);
  const float over_pi = texel_solid_angle(float(p.side), ray_length) / 3.14159265358979;
  const mat4 to_camera = faces.camera_from_face[p.map * 6 + face];
  const vec3 way = ray * (seen.a / ray_length);
  TexelLight t;
  t.radiance = seen.rgb;
  t.position = (to_camera * vec4(way, 1.0)).xyz;
  t.gain = seen.a * seen.a * over_pi;
  t.shrink = 1.0 - over_pi;
  texels.data[index] = t;
}
