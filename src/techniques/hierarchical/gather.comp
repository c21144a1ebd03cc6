// SPDX-License-Identifier: MIT
// The light that reaches each pixel of one level from the level's ring: HSSIL (4) and section 3.2.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

// Each thread takes several pixels of a column, three rows apart: they have the same place in the
// 3 x 3 cells of spiral_start(), hence the same offsets, and share the work of finding them.
layout(constant_id = 0) const uint pixels_per_thread = 1;
// 0: HSSIL (4), 1: HSSIL (3).
layout(constant_id = 1) const uint form_factor = 0;
layout(local_size_x = 32, local_size_y = 3) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D indirect;
layout(push_constant, scalar) uniform Push { GatherParams p; };

void main() {
  const ivec2 first = ivec2(gl_WorkGroupID.xy) * ivec2(32, 3 * pixels_per_thread) +
                      ivec2(gl_LocalInvocationID.xy);
  if (first.x >= p.extent.x || first.y >= p.extent.y) return;

  vec2 ray[pixels_per_thread];
  vec3 position[pixels_per_thread];
  vec3 normal[pixels_per_thread];
  vec3 light[pixels_per_thread];
  float taken[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first + ivec2(0, 3 * k);
    const vec4 g = imageLoad(geometry, pixel);
    ray[k] = ray_through(p.screen, vec2(pixel) + 0.5);
    position[k] = position_view(ray[k], g.w);
    normal[k] = g.xyz;
    light[k] = vec3(0.0);
    taken[k] = 0.0;
  }

  const vec2 start = spiral_start(uvec2(first), p.level, p.seed, p.rotate != 0);
  const float turn = start.y * 6.28318530718;
  vec2 direction = vec2(cos(turn), sin(turn));
  const mat2 golden_turn = mat2(cos(kGoldenAngle), sin(kGoldenAngle),
                                -sin(kGoldenAngle), cos(kGoldenAngle));
  const float step_px2 = sample_step_px2(p.inner_px, p.outer_px, p.samples);
  for (uint i = 0; i < p.samples; ++i) {
    const float radius_px = sample_radius_px(p.inner_px, step_px2, float(i) + start.x);
    const vec2 offset = floor(direction * radius_px + 0.5);
    const vec2 ray_offset = offset * p.screen.ray_scale;
    direction = golden_turn * direction;
    // All loads first: they do not wait for each other's arithmetic (0.86 of the time on a CPU).
    // Outside of the image rgb is 0 (robustImageAccess): such a sample is black, and is counted.
    const ivec2 column = first + ivec2(offset);
    const bool is_column_inside = uint(column.x) < uint(p.extent.x);
    vec4 g[pixels_per_thread];
    vec4 s[pixels_per_thread];
    for (uint k = 0; k < pixels_per_thread; ++k) {
      const ivec2 q = column + ivec2(0, 3 * k);
      g[k] = imageLoad(geometry, q);
      s[k] = imageLoad(source, q);
      taken[k] += is_column_inside && uint(q.y) < uint(p.extent.y) ? 1.0 : 0.0;
    }
    for (uint k = 0; k < pixels_per_thread; ++k) {
      const vec3 to_patch = position_view(ray[k] + ray_offset, g[k].w) - position[k];
      const float area_over_pi = p.area_over_pi * g[k].w * g[k].w * s[k].a;  // HSSIL (2)
      const float factor =
          form_factor == 1 ? point_form_factor(to_patch, normal[k], g[k].xyz, area_over_pi)
                           : disc_form_factor(to_patch, normal[k], g[k].xyz, area_over_pi);
      light[k] += s[k].rgb * factor;
    }
  }

  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first + ivec2(0, 3 * k);
    if (pixel.y < p.extent.y)
      imageStore(indirect, pixel,
                 vec4(min(light[k], vec3(65504.0)), 1.0 - taken[k] / float(p.samples)));
  }
}
