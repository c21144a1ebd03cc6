// SPDX-License-Identifier: MIT
// What prepare.comp and downsample.comp share: how a level of the pyramid is made and stored.
//
//   geometry  rgba32f: unit normal in view space, z (distance along the optical axis; 0: nothing)
//   source    rgba16f: radiance times the share of the pixel that is covered, foreshortening
//
// HSSIL 4, filter `closest`: of the pixels below, the one nearest to the camera decides.
// differs: it decides which surface is kept, and the pixels on that surface are averaged; the paper
// keeps the one pixel. That one lies beside the large pixel's centre, always to the same side of a
// curved surface, and its normal and position do not fit each other there: inside a sphere the
// light gathered from near rings came out 9 to 15 % too high.
#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

const float kNothingZ = 3.0e38;

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

void add_to_surface(inout SurfaceSum sum, vec4 nearest, vec2 nearest_ray, vec4 child,
                    vec2 child_ray, vec2 ray) {
  const float weight =
      bilateral_weight(position_view(nearest_ray, nearest.w), nearest.xyz,
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
