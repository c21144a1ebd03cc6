// SPDX-License-Identifier: MIT
// How much of the hemisphere is above the horizons of its slices; in alpha, for the filter.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/baselines/hbao/params.h"
#include "techniques/baselines/slice.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform writeonly image2D light;
layout(push_constant, scalar) uniform Push { HbaoParams p; };

// What one side of a slice has below its horizon, as a share of the slice: the shares of all
// samples begin at the hemisphere's end, so that the largest is that of the horizon. `end` is the
// share at that end, 1 where `direction` leads to.
float closed_share(vec3 position, vec2 at_px, vec2 direction, float end, Slice slice,
                   float shift) {
  const float reach = reach_px(at_px, direction, vec2(p.extent), p.radius_m, -position.z,
                               direction * p.screen.ray_scale);
  float most = 0.0;
  for (uint i = 0; i < p.samples; ++i) {
    const vec2 sample_px = at_px + direction * sample_offset_px(i, p.samples, shift, reach);
    const ivec2 q = ivec2(floor(sample_px));
    const vec4 surface = imageLoad(geometry, q);
    const vec2 ray = ray_through(p.screen, sample_px);
    const float z = z_on_line(surface, ray_through(p.screen, vec2(q) + 0.5), ray);
    const vec3 to_sample = position_view(ray, z) - position;
    const float near = 1.0 - length(to_sample) / p.radius_m;
    if (surface.w == 0.0 || near < 0.0) continue;
    const float below = abs(end - share_below(slice, slice_angle(slice, to_sample)));
    most = max(most, below * min(near / max(p.falloff, 1e-6), 1.0));
  }
  return most;
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 own = imageLoad(geometry, pixel);
  const vec2 at_px = vec2(pixel) + 0.5;
  const vec3 position = position_view(ray_through(p.screen, at_px), own.w);
  float open = 0.0;
  float weights = 0.0;
  if (own.w > 0.0) {
    for (uint k = 0; k < p.slices; ++k) {
      const vec2 start = slice_start(uvec2(pixel), p.seed, k);
      const vec2 direction = slice_direction(k, p.slices, start.y);
      const Slice slice = slice_of(position, own.xyz, direction, p.screen.ray_scale);
      const float closed = closed_share(position, at_px, direction, 1.0, slice, start.x) +
                           closed_share(position, at_px, -direction, 0.0, slice, start.x);
      open += slice.weight * (1.0 - closed);
      weights += slice.weight;
    }
  }
  imageStore(light, pixel, vec4(0.0, 0.0, 0.0, weights > 0.0 ? max(open / weights, 0.0) : 1.0));
}
