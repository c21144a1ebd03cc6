// SPDX-License-Identifier: MIT
// gather.comp with every pixel of the ring as a sample. For judging what sampling costs in quality;
// slow.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/params.h"

// 0: HSSIL (4), 1: HSSIL (3).
layout(constant_id = 1) const uint form_factor = 0;
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D indirect;
layout(push_constant, scalar) uniform Push { GatherParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 receiver = imageLoad(geometry, pixel);
  const vec3 position = position_view(ray_through(p.screen, vec2(pixel) + 0.5), receiver.w);

  // A pixel belongs to the ring that its centre lies in.
  const int reach = int(ceil(p.outer_px));
  const float inner2 = p.inner_px * p.inner_px;
  const float outer2 = p.outer_px * p.outer_px;
  const ivec2 from = max(pixel - reach, ivec2(0));
  const ivec2 to = min(pixel + reach, p.extent - 1);
  vec3 light = vec3(0.0);
  float taken = 0.0;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      const vec2 offset = vec2(ivec2(x, y) - pixel);
      const float distance2 = dot(offset, offset);
      if (distance2 < inner2 || distance2 >= outer2) continue;
      taken += 1.0;
      const vec4 g = imageLoad(geometry, ivec2(x, y));
      const vec4 s = imageLoad(source, ivec2(x, y));
      const vec3 to_patch =
          position_view(ray_through(p.screen, vec2(x, y) + 0.5), g.w) - position;
      const float area_over_pi = p.area_over_pi * g.w * g.w * s.a;  // HSSIL (2)
      light += s.rgb * (form_factor == 1
                            ? point_form_factor(to_patch, receiver.xyz, g.xyz, area_over_pi)
                            : disc_form_factor(to_patch, receiver.xyz, g.xyz, area_over_pi));
    }
  }
  const float ring = 3.14159265 * (outer2 - inner2);
  imageStore(indirect, pixel,
             vec4(min(light, vec3(65504.0)), clamp(1.0 - taken / ring, 0.0, 1.0)));
}
