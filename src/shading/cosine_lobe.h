// SPDX-License-Identifier: MIT
// Phong's lobe and its generalisation by Lafortune et al., "Non-Linear Approximation of Reflectance
// Functions", 1997: see CosineLobe in lueur/g_buffer.h.
#ifndef LUEUR_SHADING_COSINE_LOBE_H
#define LUEUR_SHADING_COSINE_LOBE_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// CosineLobe of lueur/g_buffer.h.
struct CosineLobeData {
  float exponent;
  float c_xy;
  float c_z;
};

// The brdf for a colour of 1, without the cosine. Directions are unit and point away from the
// surface. 0 where the coefficients or the mirrored eye's share of the light's direction vanish,
// also for an exponent of 0: devices leave 0 / 0 and 0 to the 0 undefined.
LUEUR_SHARED float cosine_lobe(float exponent, float c_xy, float c_z, vec3 normal, vec3 to_light,
                               vec3 to_eye) {
  const float along = dot(normal, to_light) * dot(normal, to_eye);
  const float across = dot(to_light, to_eye) - along;
  const float cosine = c_xy * across + c_z * along;
  if (!(cosine > 0.0f)) return 0.0f;
  const float m = max(abs(c_xy), abs(c_z));
  return (exponent + 2.0f) / 6.28318530717959f * pow(cosine / m, exponent);
}

// Where the lobe peaks, unit; the normal, if it peaks nowhere: coefficients of 0, or c_z = 0 seen
// along the normal.
LUEUR_SHARED vec3 cosine_lobe_axis(float c_xy, float c_z, vec3 normal, vec3 to_eye) {
  const float up = dot(normal, to_eye);
  const vec3 axis = c_xy * (to_eye - up * normal) + (c_z * up) * normal;
  const float squared_length = dot(axis, axis);
  return squared_length > 0.0f ? axis * inversesqrt(squared_length) : normal;
}

LUEUR_NAMESPACE_END

#endif
