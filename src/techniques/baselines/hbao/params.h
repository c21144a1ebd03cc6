// SPDX-License-Identifier: MIT
// What the technique's own pass gets from the CPU.
#ifndef LUEUR_TECHNIQUES_BASELINES_HBAO_PARAMS_H
#define LUEUR_TECHNIQUES_BASELINES_HBAO_PARAMS_H

#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

struct HbaoParams {
  Screen screen;
  ivec2 extent;
  uint slices;
  uint samples;  // a side of each slice
  uint seed;
  float radius_m;
  float falloff;  // share of the radius
};

LUEUR_NAMESPACE_END

#endif
