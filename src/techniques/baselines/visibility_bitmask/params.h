// SPDX-License-Identifier: MIT
// What the technique's own pass gets from the CPU, and its sectors.
#ifndef LUEUR_TECHNIQUES_BASELINES_VISIBILITY_BITMASK_PARAMS_H
#define LUEUR_TECHNIQUES_BASELINES_VISIBILITY_BITMASK_PARAMS_H

#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

struct BitmaskParams {
  Screen screen;
  ivec2 extent;
  uint slices;
  uint samples;  // a side of each slice
  uint seed;
  float radius_m;
  float distance_m;  // of occlusion
  float thickness_m;
};

// Those of 32 sectors of equal weight that lie between two shares of a slice, low <= high. A sector
// counts as a whole or not at all; with `dither` even over [0, 1), their mean number is exact.
LUEUR_SHARED uint sectors_between(float low, float high, float dither) {
  const uint first = uint(32.0f * low + dither), end = uint(32.0f * high + dither);
  const uint count = end - first;
  return count == 0u ? 0u : (0xffffffffu >> (32u - count)) << first;
}

// The dither of a slice whose samples are shifted by `shift`.
LUEUR_SHARED float sector_dither(float shift, uint slice) {
  return fract(2.0f * shift + 0.5698402910f * float(slice));
}

LUEUR_NAMESPACE_END

#endif
