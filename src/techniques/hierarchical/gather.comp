// SPDX-License-Identifier: MIT
// The light that reaches each pixel of one level from the level's ring: HSSIL (4) and section 3.2.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

// Each thread takes several pixels of a row, a workgroup's width apart: the loop's own work is
// shared, and neighbouring threads still read neighbouring pixels.
layout(constant_id = 0) const uint pixels_per_thread = 4;
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D indirect;
layout(push_constant, scalar) uniform Push { GatherParams p; };

void main() {
  const ivec2 first = ivec2(gl_WorkGroupID.xy) * ivec2(8 * pixels_per_thread, 8) +
                      ivec2(gl_LocalInvocationID.xy);
  if (first.x >= p.extent.x || first.y >= p.extent.y) return;

  vec3 position[pixels_per_thread];
  vec3 normal[pixels_per_thread];
  vec2 direction[pixels_per_thread];
  float shift[pixels_per_thread];
  vec3 light[pixels_per_thread];
  float lost[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first + ivec2(8 * k, 0);
    const vec4 g = imageLoad(geometry, min(pixel, p.extent - 1));
    position[k] = position_view(ray_through(p.screen, vec2(pixel) + 0.5), g.w);
    normal[k] = g.xyz;
    const vec2 start = spiral_start(uvec2(pixel), p.level, p.seed, p.rotate != 0);
    shift[k] = start.x;
    const float turn = start.y * 6.28318530718;
    direction[k] = vec2(cos(turn), sin(turn));
    light[k] = vec3(0.0);
    lost[k] = 0.0;
  }

  const float inner2 = p.inner_px * p.inner_px;
  const float step2 = (p.outer_px * p.outer_px - inner2) / float(p.samples);
  const mat2 golden_turn = mat2(cos(kGoldenAngle), sin(kGoldenAngle),
                                -sin(kGoldenAngle), cos(kGoldenAngle));
  const vec2 last = vec2(p.extent - 1);
  for (uint i = 0; i < p.samples; ++i) {
    for (uint k = 0; k < pixels_per_thread; ++k) {
      const float radius_px = sqrt(inner2 + step2 * (float(i) + shift[k]));
      const vec2 wanted = floor(vec2(first + ivec2(8 * k, 0)) + 0.5 + direction[k] * radius_px);
      direction[k] = golden_turn * direction[k];
      // Samples outside of the image give nothing, and are counted.
      const vec2 inside = clamp(wanted, vec2(0.0), last);
      const float weight = inside == wanted ? 1.0 : 0.0;
      lost[k] += 1.0 - weight;

      const ivec2 q = ivec2(inside);
      const vec4 g = imageLoad(geometry, q);
      const vec4 s = imageLoad(source, q);
      const vec3 to_patch =
          position_view(ray_through(p.screen, inside + 0.5), g.w) - position[k];
      const float area_over_pi = p.area_over_pi * g.w * g.w * s.a;  // HSSIL (2)
      const float factor =
          p.point != 0 ? point_form_factor(to_patch, normal[k], g.xyz, area_over_pi)
                       : disc_form_factor(to_patch, normal[k], g.xyz, area_over_pi);
      light[k] += s.rgb * (weight * factor);
    }
  }

  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first + ivec2(8 * k, 0);
    if (pixel.x < p.extent.x)
      imageStore(indirect, pixel,
                 vec4(min(light[k], vec3(65504.0)), lost[k] / float(p.samples)));
  }
}
