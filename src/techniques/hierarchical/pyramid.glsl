// SPDX-License-Identifier: MIT
// What prepare.comp and downsample.comp share: how a level of the pyramid is made and stored.
//
//   geometry  rgba32f: unit normal in view space, z (distance along the optical axis; 0: nothing)
//   source    rgba16f: radiance times the share of the pixel that is covered, foreshortening
//
// Of the pixels below, one decides. Filter `closest`, HSSIL 4: the one nearest to the camera.
// Filter `vote`, FDP (5): the one whose surface its neighbours share the most.
// differs: it decides which surface is kept, and the pixels on that surface are averaged; the paper
// keeps the one pixel. That one lies beside the large pixel's centre, always to the same side of a
// curved surface, and its normal and position do not fit each other there: inside a sphere the
// light gathered from near rings came out 9 to 15 % too high.
#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

// 0: `closest`, 1: `vote`.
layout(constant_id = 1) const uint by_vote = 0;

// Unit normal in view space and z of a pixel of the finer image; z = 0 where there is no surface
// and outside of the image.
vec4 fine_surface(ivec2 fine_pixel);

// FDP (5): the score of a pixel, from itself and its four neighbours.
float score(vec4 own, ivec2 fine_pixel) {
  float sum = vote(0.0, 1.0, 0.0, own.w);
  for (int j = 0; j < 4; ++j) {
    const int side = (j & 1) * 2 - 1;
    const vec4 other = fine_surface(fine_pixel + (j < 2 ? ivec2(side, 0) : ivec2(0, side)));
    if (other.w > 0.0) sum += vote(1.0, dot(own.xyz, other.xyz), other.w - own.w, own.w);
  }
  return sum;
}

// Larger than for any pixel before: this one decides.
float claim(vec4 own, ivec2 fine_pixel) {
  if (own.w <= 0.0) return 0.0;
  return by_vote == 1 ? score(own, fine_pixel) : 1.0 / own.w;
}

// z where the ray `to_ray` meets the plane of a point seen along `from_ray`: a flat wall stays flat
// at every level. Bounded to half and twice z, for planes seen edge-on.
float slide_along_plane(float z, vec2 from_ray, vec3 n, vec2 to_ray) {
  const float from = n.z - dot(n.xy, from_ray);
  const float to = n.z - dot(n.xy, to_ray);
  if (from <= 0.0 || to <= 0.0) return z;
  return z * clamp(from / to, 0.5, 2.0);
}

// The sum over the pixels of one surface.
struct SurfaceSum {
  vec3 normal;
  float z;
  float weight;
};

void add_to_surface(inout SurfaceSum sum, vec4 decider, vec2 decider_ray, vec4 child,
                    vec2 child_ray, vec2 ray) {
  const float weight =
      bilateral_weight(position_view(decider_ray, decider.w), decider.xyz,
                       position_view(child_ray, child.w), child.xyz, kFlatness);
  sum.normal += weight * child.xyz;
  sum.z += weight * slide_along_plane(child.w, child_ray, child.xyz, ray);
  sum.weight += weight;
}

vec4 surface_mean(SurfaceSum sum) {
  return sum.weight > 0.0 ? vec4(normalize(sum.normal), sum.z / sum.weight) : vec4(0.0);
}

#define write_level(pixel, surface, ray, radiance)                                     \
  imageStore(geometry_out, pixel, surface);                                            \
  imageStore(source_out, pixel,                                                        \
             vec4(min(radiance, vec3(65504.0)),                                        \
                  surface.w > 0.0 ? foreshortening(surface.xyz, ray, kMostForeshortening) : 0.0))
