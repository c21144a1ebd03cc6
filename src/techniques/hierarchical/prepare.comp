// SPDX-License-Identifier: MIT
// The engine's G-buffer -> level 0 of the pyramid.
//
// Position and normal of factor x factor pixels by the filter in pyramid.glsl; radiance is
// averaged.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/packing.h"
#include "techniques/hierarchical/pyramid.glsl"

// Pixels of the G-buffer a side of one level pixel: 1, 2 or 4.
layout(constant_id = 0) const int factor = 2;
// One row of pixels a workgroup: texel fetches of whole rows take 0.6 of the time that squares take
// on a CPU.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D source;
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D geometry_out;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D source_out;
layout(set = 0, binding = 5, scalar) uniform Params { PrepareParams value; } params;

vec4 surface_of(float d, vec2 n, ivec2 fine_pixel) {
  const PrepareParams p = params.value;
  const bool is_surface = d != p.screen.depth_of_nothing &&
                          all(lessThan(uvec2(fine_pixel), uvec2(p.full_extent)));
  return is_surface ? vec4(p.view_from_world * octahedral_decode(n), z_from_depth(p.screen, d))
                    : vec4(0.0);
}

vec4 fine_surface(ivec2 fine_pixel) {
  const ivec2 inside = clamp(fine_pixel, ivec2(0), params.value.full_extent - 1);
  return surface_of(texelFetch(depth, inside, 0).r, texelFetch(normal, inside, 0).rg, fine_pixel);
}

void main() {
  const PrepareParams p = params.value;
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;

  // All fetches first: they do not wait for each other's arithmetic.
  float d[factor * factor];
  vec2 n[factor * factor];
  vec3 radiance[factor * factor];
  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 child =
        min(pixel * factor + ivec2(i % factor, i / factor), p.full_extent - 1);
    d[i] = texelFetch(depth, child, 0).r;
    n[i] = texelFetch(normal, child, 0).rg;
    radiance[i] = texelFetch(source, child, 0).rgb;
  }

  // Normal in view space and z of each pixel; z = 0 where there is no surface, and beyond the
  // image's edge. Both count as black: the sum of radiance times area is the same at every level.
  vec4 children[factor * factor];
  int decider = 0;
  float most = 0.0;
  vec3 radiance_sum = vec3(0.0);
  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 child = pixel * factor + ivec2(i % factor, i / factor);
    children[i] = surface_of(d[i], n[i], child);
    if (children[i].w > 0.0) radiance_sum += radiance[i];
    const float claimed = claim(children[i], child);
    if (claimed > most) decider = i;
    most = max(most, claimed);
  }

  const vec2 first_ray = ray_through(p.screen, vec2(pixel * factor) + 0.5);
  const vec2 ray = ray_through(p.screen, (vec2(pixel) + 0.5) * float(factor));
  const vec2 decider_ray =
      first_ray + vec2(decider % factor, decider / factor) * p.screen.ray_scale;
  SurfaceSum sum = SurfaceSum(vec3(0.0), 0.0, 0.0);
  for (int i = 0; i < factor * factor; ++i)
    if (children[i].w > 0.0)
      add_to_surface(sum, children[decider], decider_ray, children[i],
                     first_ray + vec2(i % factor, i / factor) * p.screen.ray_scale, ray);
  const vec4 surface = surface_mean(sum);
  write_level(pixel, surface, ray, radiance_sum / float(factor * factor));
}
