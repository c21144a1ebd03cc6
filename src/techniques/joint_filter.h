// SPDX-License-Identifier: MIT
// Which pixels belong to one surface, for filters that keep to it, and what joint_filter.comp gets.
#ifndef LUEUR_TECHNIQUES_JOINT_FILTER_H
#define LUEUR_TECHNIQUES_JOINT_FILTER_H

#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

// How much two points belong to the same smooth piece of surface, for the joint bilateral filters.
// The distance of q from p's tangent plane counts against p's depth: `flatness` is the distance, as
// a share of the depth, at which the weight is 0. Normals count with the 8th power of their cosine.
LUEUR_SHARED float bilateral_weight(vec3 position_p, vec3 normal_p, vec3 position_q, vec3 normal_q,
                                    float flatness) {
  const float distance_m = abs(dot(normal_p, position_q - position_p));
  const float near =
      max(1.0f + distance_m / (position_p.z * flatness), 0.0f);  // view z is negative
  float alike = max(dot(normal_p, normal_q), 0.0f);
  alike *= alike;
  alike *= alike;
  return near * alike * alike;
}

// 2 % of the depth.
const float kFlatness = 0.02f;

struct FilterParams {
  Screen screen;
  ivec2 extent;
  int step_px;  // from one pixel of the 3 x 3 to the next
};

LUEUR_NAMESPACE_END

#endif
