// SPDX-License-Identifier: MIT
// glTF's punctual lights: KHR_lights_punctual.
#ifndef LUEUR_SHADING_PUNCTUAL_LIGHT_H
#define LUEUR_SHADING_PUNCTUAL_LIGHT_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// Closer than this a point light shines as from here, so that light stays finite. Metres.
const float kLeastLightDistance = 1e-3f;

// What a spot keeps of its intensity at an angle from its axis:
//   clamp((cos - cos_outer) / (cos_inner - cos_outer), 0, 1)^2 = clamp(cos * scale + offset, 0,
//   1)^2
LUEUR_SHARED float cone_attenuation(float cos_angle, float scale, float offset) {
  const float ramp = clamp(cos_angle * scale + offset, 0.0f, 1.0f);
  return ramp * ramp;
}

// What is left of a point light's or spot's light at a distance, beside the inverse square, so that
// it ends at its range: clamp(1 - (d / range)^4, 0, 1). An inverse range of 0 leaves all.
LUEUR_SHARED float range_window(float distance_m, float inverse_range) {
  const float share = distance_m * inverse_range;
  return clamp(1.0f - share * share * share * share, 0.0f, 1.0f);
}

LUEUR_NAMESPACE_END

#endif
