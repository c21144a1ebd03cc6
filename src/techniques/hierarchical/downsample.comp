// SPDX-License-Identifier: MIT
// Level k of the pyramid -> level k + 1, half as wide and high, rounded up.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/pyramid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D geometry_out;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D source_out;
layout(push_constant, scalar) uniform Push { DownsampleParams p; };

// Outside of the image z loads as 0 (robustImageAccess).
vec4 fine_surface(ivec2 fine_pixel) { return imageLoad(geometry, fine_pixel); }

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;

  // As in prepare.comp: what is no surface counts as black.
  vec4 children[4];
  int decider = 0;
  float most = 0.0;
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    const ivec2 child = pixel * 2 + ivec2(i & 1, i >> 1);
    children[i] = fine_surface(child);
    radiance += imageLoad(source, child).rgb;
    const float claimed = claim(children[i], child);
    if (claimed > most) decider = i;
    most = max(most, claimed);
  }
  radiance *= 0.25;

  const vec2 ray = ray_through(p.screen, vec2(pixel) + 0.5);
  const vec2 first_ray = (vec2(pixel * 2) + 0.5) * p.fine_scale + p.screen.ray_offset;
  const vec2 decider_ray = first_ray + vec2(decider & 1, decider >> 1) * p.fine_scale;
  SurfaceSum sum = SurfaceSum(vec3(0.0), 0.0, 0.0);
  for (int i = 0; i < 4; ++i)
    if (children[i].w > 0.0)
      add_to_surface(sum, children[decider], decider_ray, children[i],
                     first_ray + vec2(i & 1, i >> 1) * p.fine_scale, ray);
  const vec4 surface = surface_mean(sum);
  write_level(pixel, surface, ray, radiance);
}
