// SPDX-License-Identifier: MIT
// A point's hemisphere in slices: half planes around the direction to the eye, each of which is a
// line on the screen. In a slice, directions are angles from that direction, positive along the
// line. As Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion",
// have it: over the slices phi and the angles h,
//   share of the cosine-weighted hemisphere = 1/pi  sum |n_p| |sin h| cos(h - gamma)  dh dphi,
// n_p being the normal projected onto the slice and gamma its angle.
#ifndef LUEUR_TECHNIQUES_BASELINES_SLICE_H
#define LUEUR_TECHNIQUES_BASELINES_SLICE_H

#include "shading/screen.h"
#include "techniques/interleaving.h"

LUEUR_NAMESPACE_BEGIN

const float kQuarterTurn = 1.57079632679490f;

struct Slice {
  vec3 to_eye;       // unit: angle 0
  vec3 along;        // unit: a quarter turn
  float normal_rad;  // gamma, from -pi/2 to pi/2
  float low;         // signed_integral() at the hemisphere's two ends, which are gamma -+ pi/2
  float range;
  float weight;  // of the slice among all of a point
};

// The integral of |sin h| cos(h - gamma) from 0 to h, negative for negative h.
LUEUR_SHARED float signed_integral(float h, float normal_rad) {
  const float integral =
      0.25f * (cos(normal_rad) - cos(2.0f * h - normal_rad) + 2.0f * h * sin(normal_rad));
  return h < 0.0f ? -integral : integral;
}

// `position` and `normal` in view space, `direction` a unit step on the screen, `ray_scale` as in
// Screen. Directions that are even on the screen are not around a ray off the optical axis; the
// weight makes up for that.
LUEUR_SHARED Slice slice_of(vec3 position, vec3 normal, vec2 direction, vec2 ray_scale) {
  Slice s;
  s.to_eye = -normalize(position);
  const vec3 step = vec3(direction * ray_scale, 0.0f);
  const vec3 seen_step = step - s.to_eye * dot(step, s.to_eye);
  s.along = normalize(seen_step);
  const vec3 across = cross(s.to_eye, s.along);
  const vec3 projected = normal - across * dot(normal, across);
  // A normal that looks away from the eye counts as if it were seen edge-on.
  s.normal_rad = atan(dot(projected, s.along), max(dot(projected, s.to_eye), 0.0f) + 1e-9f);
  s.low = signed_integral(s.normal_rad - kQuarterTurn, s.normal_rad);
  s.range = signed_integral(s.normal_rad + kQuarterTurn, s.normal_rad) - s.low;
  // The azimuth's derivative: how the map from the screen's steps to those around the ray scales
  // areas, over how it scales this length twice.
  const float turn = abs(ray_scale.x * ray_scale.y * s.to_eye.z) / dot(seen_step, seen_step);
  s.weight = length(projected) * s.range * turn;
  return s;
}

// The angle of the direction `to`, or of its projection onto the slice.
LUEUR_SHARED float slice_angle(Slice s, vec3 to) {
  return atan(dot(to, s.along), dot(to, s.to_eye));
}

// Which share of the slice's weight lies at smaller angles than h: 0 at one end of the hemisphere,
// 1 at the other, and so as close to them as rounding brings what lies in the surface's own plane.
LUEUR_SHARED float share_below(Slice s, float h) {
  const float inside = clamp(h, s.normal_rad - kQuarterTurn, s.normal_rad + kQuarterTurn);
  const float share = (signed_integral(inside, s.normal_rad) - s.low) / s.range;
  return clamp(0.5f + 1.00002f * (share - 0.5f), 0.0f, 1.0f);
}

// --- where samples lie ---

// x: by which share of a step a pixel's samples are shifted, y: by which share of the angle between
// two slices these are turned, in [0, 1). Of slice `k`, as slices shift their samples differently.
// Nine pixels of 3 x 3 interleave, and so do nine such blocks: 81 starts.
LUEUR_SHARED vec2 slice_start(uvec2 pixel, uint seed, uint k) {
  const uint block = (pixel.x / 3u) % 3u + 3u * ((pixel.y / 3u) % 3u);
  const vec2 start =
      spiral_start(pixel, 0u, seed, true) + vec2(float(block), float((4u * block) % 9u)) / 81.0f;
  return vec2(fract(start.x + 0.7548776662f * float(k)), fract(start.y));
}

// A unit direction on the screen; with the opposite one it makes slice k of `count`.
LUEUR_SHARED vec2 slice_direction(uint k, uint count, float turn) {
  const float phi = 2.0f * kQuarterTurn * (float(k) + turn) / float(count);
  return vec2(cos(phi), sin(phi));
}

// Sample i of n between the pixel itself and `reach_px`, denser near the pixel.
LUEUR_SHARED float sample_offset_px(uint i, uint n, float shift, float reach_px) {
  const float t = (float(i) + shift) / float(n);
  return 1.0f + max(reach_px - 1.0f, 0.0f) * t * t;
}

// How far a line from `at_px` goes: `radius_m` at distance z, or to the picture's edge.
LUEUR_SHARED float reach_px(vec2 at_px, vec2 direction, vec2 extent, float radius_m, float z,
                            vec2 line) {
  const float across = radius_m / (z * length(line));
  const float x =
      (direction.x > 0.0f ? extent.x - at_px.x : at_px.x) / max(abs(direction.x), 1e-6f);
  const float y =
      (direction.y > 0.0f ? extent.y - at_px.y : at_px.y) / max(abs(direction.y), 1e-6f);
  return min(across, min(x, y));
}

// z of the surface of pixel q where its plane meets the line, and not where the pixel has its
// middle: the plane of a floor then lies in each of its slices. `surface` is normal and z, rays are
// (x, y, -1). No farther than to half or double z, as a surface seen edge-on reaches anywhere.
LUEUR_SHARED float z_on_line(vec4 surface, vec2 ray_of_q, vec2 ray) {
  const vec3 n = vec3(surface.x, surface.y, surface.z);
  const float facing = dot(n, vec3(ray, -1.0f)), facing_q = dot(n, vec3(ray_of_q, -1.0f));
  return facing < 0.0f ? surface.w * clamp(facing_q / facing, 0.5f, 2.0f) : surface.w;
}

LUEUR_NAMESPACE_END

#endif
