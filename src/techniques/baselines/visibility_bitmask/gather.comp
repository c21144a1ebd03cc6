// SPDX-License-Identifier: MIT
// The light of what samples newly cover, and in alpha how much of the hemisphere stays open.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/baselines/slice.h"
#include "techniques/baselines/visibility_bitmask/params.h"

// 1: light is multiplied by the cosine at which it leaves, as in the paper.
layout(constant_id = 0) const uint emitter_cosine = 0;
// 1: what lies between two samples of one surface is covered, too.
layout(constant_id = 1) const uint bridge = 1;
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1) uniform sampler2D source;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D light;
layout(push_constant, scalar) uniform Push { BitmaskParams p; };

struct Covered {
  uint by_all;   // sectors, for light
  uint by_near;  // sectors, for occlusion
  vec3 light;    // in sectors
};

// One side of a slice, from near to far. `direction` is a unit step on the screen, toward the share
// `end`: 1 or 0.
void march(vec3 position, vec2 at_px, vec2 direction, float end, Slice slice, float shift,
           float dither, inout Covered covered) {
  const float reach = reach_px(at_px, direction, vec2(p.extent), p.radius_m, -position.z,
                               direction * p.screen.ray_scale);
  // The sample before, at first the point itself, at the hemisphere's end.
  vec3 last = position;
  float last_share = end;
  bool has_last = bridge == 1;
  for (uint i = 0; i < p.samples; ++i) {
    const vec2 sample_px = at_px + direction * sample_offset_px(i, p.samples, shift, reach);
    const ivec2 q = ivec2(floor(sample_px));
    const vec4 surface = imageLoad(geometry, q);
    const vec2 ray = ray_through(p.screen, sample_px);
    const float z = z_on_line(surface, ray_through(p.screen, vec2(q) + 0.5), ray);
    const vec3 front = position_view(ray, z);
    const vec3 to_front = front - position;
    const float r2 = dot(to_front, to_front);
    if (surface.w == 0.0 || r2 > p.radius_m * p.radius_m) {
      has_last = false;
      continue;
    }

    const vec3 to_back = to_front + normalize(front) * p.thickness_m;
    const float a = share_below(slice, slice_angle(slice, to_front));
    const float b = share_below(slice, slice_angle(slice, to_back));
    float low = min(a, b);
    float high = max(a, b);
    if (has_last && abs(dot(surface.xyz, front - last)) < p.thickness_m) {
      low = min(low, last_share);
      high = max(high, last_share);
    }
    last = front;
    last_share = a;
    has_last = bridge == 1;
    const uint sectors = sectors_between(low, high, dither);
    const uint fresh = sectors & ~covered.by_all;
    covered.by_all |= sectors;
    if (r2 <= p.distance_m * p.distance_m) covered.by_near |= sectors;
    if (fresh == 0u) continue;
    const float cosine = -dot(surface.xyz, to_front) * inversesqrt(r2);
    const float gives = emitter_cosine == 1 ? max(cosine, 0.0) : step(1e-4, cosine);
    covered.light += texelFetch(source, q, 0).rgb * (gives * float(bitCount(fresh)));
  }
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 own = imageLoad(geometry, pixel);
  if (own.w == 0.0) {
    imageStore(light, pixel, vec4(0.0, 0.0, 0.0, 1.0));
    return;
  }
  const vec2 at_px = vec2(pixel) + 0.5;
  const vec3 position = position_view(ray_through(p.screen, at_px), own.w);
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (uint k = 0; k < p.slices; ++k) {
    const vec2 start = slice_start(uvec2(pixel), p.seed, k);
    const vec2 direction = slice_direction(k, p.slices, start.y);
    const Slice slice = slice_of(position, own.xyz, direction, p.screen.ray_scale);
    const float dither = sector_dither(start.x, k);
    Covered covered = Covered(0u, 0u, vec3(0.0));
    march(position, at_px, direction, 1.0, slice, start.x, dither, covered);
    march(position, at_px, -direction, 0.0, slice, start.x, dither, covered);
    const float open = 1.0 - float(bitCount(covered.by_near)) / 32.0;
    sum += slice.weight * vec4(covered.light / 32.0, open);
    weights += slice.weight;
  }
  imageStore(light, pixel, min(sum / weights, vec4(65504.0)));
}
