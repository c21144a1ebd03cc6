// SPDX-License-Identifier: MIT
// How much of what a small patch radiates arrives at a point.
#ifndef LUEUR_SHADING_FORM_FACTOR_H
#define LUEUR_SHADING_FORM_FACTOR_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// What bounds foreshortening(): pixels that see their surface at less than 2.9 degrees count as if
// it were 2.9.
const float kMostForeshortening = 20.0f;

// cos(alpha) / cos(beta) in HSSIL (2): how much larger a surface seen in a pixel is than a
// screen-parallel one at its depth. With the pixel's ray v = (x, y, -1), cos(alpha) = 1 / |v| and
// cos(beta) = -n.v / |v|, so the ratio is 1 / -n.v. `most` bounds it: a pixel that sees its surface
// edge-on says little about the surface's area.
LUEUR_SHARED float foreshortening(vec3 normal_view, vec2 ray, float most) {
  const float facing = normal_view.z - normal_view.x * ray.x - normal_view.y * ray.y;
  return 1.0f / max(facing, 1.0f / most);
}

// Irradiance over pi that a patch of radiance 1 gives to a point: HSSIL (4), point to disc.
//   cos(theta) cos(theta') ds / (pi r^2)  ~  R^2 cos(theta) / (r^2 + R^2),  R^2 = cos(theta') ds /
//   pi
// `to_patch` goes from the receiver to the patch; normals are unit; area_over_pi = ds / pi. Exact
// for a parallel disc above the receiver, and never above 1. With a = r cos(theta'), b = r
// cos(theta) and both sides of the fraction times r^2 it takes one square root and one division:
//   a b ds/pi / (r^4 + a r ds/pi)
LUEUR_SHARED float disc_form_factor(vec3 to_patch, vec3 normal_receiver, vec3 normal_patch,
                                    float area_over_pi) {
  const float r2 = dot(to_patch, to_patch);
  const float a = max(-dot(normal_patch, to_patch), 0.0f) * area_over_pi;
  const float b = max(dot(normal_receiver, to_patch), 0.0f);
  return a * b / (r2 * r2 + a * sqrt(r2) + 1e-30f);
}

// The same by HSSIL (3), point to differential area: grows without bound as r goes to 0.
LUEUR_SHARED float point_form_factor(vec3 to_patch, vec3 normal_receiver, vec3 normal_patch,
                                     float area_over_pi) {
  const float r2 = dot(to_patch, to_patch);
  const float a = max(-dot(normal_patch, to_patch), 0.0f) * area_over_pi;
  const float b = max(dot(normal_receiver, to_patch), 0.0f);
  return a * b / (r2 * r2 + 1e-30f);
}

// As point_form_factor(), bounded in another way: beside r^2 once stands `least_r2`, and if that is
// ds / pi, a facing patch counts as the disc that it is. Cheaper by a square root, and too dark
// near patches that are seen edge-on. `normal_area` is the patch's normal times ds / pi.
LUEUR_SHARED float bounded_form_factor(vec3 to_patch, vec3 normal_receiver, vec3 normal_area,
                                       float least_r2) {
  const float r2 = dot(to_patch, to_patch);
  const float a = max(-dot(normal_area, to_patch), 0.0f);
  const float b = max(dot(normal_receiver, to_patch), 0.0f);
  return a * b / (r2 * (r2 + least_r2) + 1e-30f);
}

LUEUR_NAMESPACE_END

#endif
