// SPDX-License-Identifier: MIT
// Halton's sequence: points that fill a square evenly, however many of them are taken.
#ifndef LUEUR_SHADING_HALTON_H
#define LUEUR_SHADING_HALTON_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// The digits of i in this base, mirrored at the point: 0.a0 a1 a2 ... for i = ... a2 a1 a0.
LUEUR_SHARED float radical_inverse(uint base, uint i) {
  float value = 0.0f;
  float digit = 1.0f / float(base);
  for (; i > 0u; i /= base) {
    value += float(i % base) * digit;
    digit /= float(base);
  }
  return value;
}

// In bases 2 and 3. The point of i = 0 is the square's corner.
LUEUR_SHARED vec2 halton_2_3(uint i) {
  return vec2(radical_inverse(2u, i), radical_inverse(3u, i));
}

LUEUR_NAMESPACE_END

#endif
