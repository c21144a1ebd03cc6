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

LUEUR_NAMESPACE_END

#endif
