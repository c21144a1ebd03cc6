// SPDX-License-Identifier: MIT
// What the passes get from the CPU.
#ifndef LUEUR_CUBE_MAPS_PARAMS_H
#define LUEUR_CUBE_MAPS_PARAMS_H

#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

struct TexelsParams {
  Screen screen;  // of the view, at its own extent
  ivec2 corner;   // where the first texel goes
  uint factor;    // pixels a side of a texel
  float far_m;
  uint has_background;
};

// A map's texels are those of its six faces, side by side in a row of the atlas.
struct PlaceParams {
  Screen screen;  // of a face of side x side texels
  int side;
  int map;
  uint texels;
};

LUEUR_NAMESPACE_END

#endif
