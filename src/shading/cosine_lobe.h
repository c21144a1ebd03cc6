// SPDX-License-Identifier: MIT
// Phong's lobe and its generalisation by Lafortune et al., "Non-Linear Approximation of Reflectance
// Functions", 1997: see CosineLobe in lueur/g_buffer.h.
#ifndef LUEUR_SHADING_COSINE_LOBE_H
#define LUEUR_SHADING_COSINE_LOBE_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// The brdf for a colour of 1, without the cosine. Directions are unit and point away from the
// surface.
LUEUR_SHARED float cosine_lobe(float exponent, float c_xy, float c_z, vec3 normal, vec3 to_light,
                               vec3 to_eye) {
  const float along = dot(normal, to_light) * dot(normal, to_eye);
  const float across = dot(to_light, to_eye) - along;
  const float m = max(abs(c_xy), abs(c_z));
  const float cosine = max(c_xy * across + c_z * along, 0.0f) / m;
  return (exponent + 2.0f) / 6.28318530717959f * pow(cosine, exponent);
}

// Where the lobe peaks; not unit.
LUEUR_SHARED vec3 cosine_lobe_peak(float c_xy, float c_z, vec3 normal, vec3 to_eye) {
  const float up = dot(normal, to_eye);
  return c_xy * (to_eye - up * normal) + (c_z * up) * normal;
}

LUEUR_NAMESPACE_END

#endif
