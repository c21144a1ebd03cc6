// SPDX-License-Identifier: MIT
// The engine's G-buffer -> level 0 of the pyramid.
//
// Position and normal of factor x factor pixels by the filter in pyramid.glsl; radiance is averaged.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/packing.h"
#include "techniques/hierarchical/pyramid.glsl"

// Pixels of the G-buffer a side of one level pixel: 1, 2 or 4.
layout(constant_id = 0) const int factor = 2;
// One row of pixels a workgroup: texel fetches of whole rows take 0.6 of the time that squares take on
// a CPU.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D source;
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D geometry_out;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D source_out;
layout(set = 0, binding = 5, scalar) uniform Params { PrepareParams value; } params;

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

  // Normal in view space and z of each pixel; z = 0 where there is no surface, and beyond the image's
  // edge. Both count as black: the sum of radiance times area is the same at every level.
  vec4 children[factor * factor];
  int nearest = 0;
  vec3 radiance_sum = vec3(0.0);
  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 child = pixel * factor + ivec2(i % factor, i / factor);
    const bool is_surface =
        d[i] != p.screen.depth_of_nothing && all(lessThan(child, p.full_extent));
    children[i] = is_surface ? vec4(p.view_from_world * octahedral_decode(n[i]),
                                    z_from_depth(p.screen, d[i]))
                             : vec4(0.0);
    if (is_surface) radiance_sum += radiance[i];
    const bool is_first = children[nearest].w == 0.0;
    if (is_surface && (is_first || children[i].w < children[nearest].w)) nearest = i;
  }

  const vec2 first_ray = ray_through(p.screen, vec2(pixel * factor) + 0.5);
  const vec2 ray = ray_through(p.screen, (vec2(pixel) + 0.5) * float(factor));
  const vec2 nearest_ray =
      first_ray + vec2(nearest % factor, nearest / factor) * p.screen.ray_scale;
  SurfaceSum sum = SurfaceSum(vec3(0.0), 0.0, 0.0);
  for (int i = 0; i < factor * factor; ++i)
    if (children[i].w > 0.0)
      add_to_surface(sum, children[nearest], nearest_ray, children[i],
                     first_ray + vec2(i % factor, i / factor) * p.screen.ray_scale, ray);
  const vec4 surface = surface_mean(sum);
  write_level(pixel, surface, ray, radiance_sum / float(factor * factor));
}
