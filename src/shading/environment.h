// SPDX-License-Identifier: MIT
// Where a direction lies in a picture of everything around (equirectangular projection): the middle
// column looks along -z, the middle of the right half along +x, the top row is +y.
#ifndef LUEUR_SHADING_ENVIRONMENT_H
#define LUEUR_SHADING_ENVIRONMENT_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

const float kEnvironmentPi = 3.14159265358979f;

// u to the right and v down, 0 to 1. `direction` is not 0 and need not be unit; straight up and
// down any u will do.
LUEUR_SHARED vec2 environment_uv(vec3 direction) {
  const float across = sqrt(direction.x * direction.x + direction.z * direction.z);
  const float u = across > 0.0f ? atan(direction.x, -direction.z) / (2.0f * kEnvironmentPi) : 0.0f;
  return vec2(0.5f + u, 0.5f - atan(direction.y, across) / kEnvironmentPi);
}

LUEUR_NAMESPACE_END

#endif
