// SPDX-License-Identifier: MIT
// Which samples a pixel takes, so that its neighbours take others.
#ifndef LUEUR_TECHNIQUES_INTERLEAVING_H
#define LUEUR_TECHNIQUES_INTERLEAVING_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// Pixels differ in where their spiral starts, with a period of 3 x 3: nine pixels together hold
// nine interleaved spirals (a rank-1 lattice in shift and turn), and the 3 x 3 filter that follows
// averages just these nine. From seed to seed, shift and turn follow Roberts' R2 sequence, so that
// the frames of an animation fill the gaps of each other. x: shift in [0, 1), y: turn in [0, 1).
LUEUR_SHARED vec2 spiral_start(uvec2 pixel, uint level, uint seed, bool rotate) {
  const float cell = rotate ? float((pixel.x % 3u) + 3u * (pixel.y % 3u)) : 4.0f;
  const float of_level = float(level) * 0.7548776662f;
  const vec2 of_seed = float(seed % 4096u) * vec2(0.7548776662f, 0.5698402910f);
  return fract(
      vec2((cell + 0.5f) / 9.0f + of_level, (cell * 4.0f + 0.5f) / 9.0f + of_level * 0.3247f) +
      of_seed);
}

LUEUR_NAMESPACE_END

#endif
