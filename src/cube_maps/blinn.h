// SPDX-License-Identifier: MIT
// The glossy lobe of LCM 5.
#ifndef LUEUR_CUBE_MAPS_BLINN_H
#define LUEUR_CUBE_MAPS_BLINN_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// Blinn's lobe for a reflectance of 1, without the cosine: c cos^n of the angle between the normal
// and the half-way vector. The paper has it without the factor
//   c = (n + 2) (n + 4) / (8 pi (2^(-n / 2) + n)),
// with which light along the normal is reflected in full.
LUEUR_SHARED float blinn_brdf(float exponent, vec3 normal, vec3 to_light, vec3 to_eye) {
  const float cosine = max(dot(normal, normalize(to_light + to_eye)), 1e-6f);
  const float c = (exponent + 2.0f) * (exponent + 4.0f) /
                  (25.1327412287183f * (pow(2.0f, -0.5f * exponent) + exponent));
  return c * pow(cosine, exponent);
}

LUEUR_NAMESPACE_END

#endif
