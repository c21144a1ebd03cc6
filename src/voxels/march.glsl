// SPDX-License-Identifier: MIT
// The walk of march.h. The shader that includes this declares the level's image as `voxels`:
//   layout(..., r32ui) uniform readonly uimage2D voxels;
// For a second grid, include it again with MARCH, the function's name, and VOXELS, the image's.

#include "voxels/march.h"

#ifndef MARCH
#define MARCH march
#define VOXELS voxels
#endif

// 1: nothing is between the points. 0: something is. For the points see march.h.
float MARCH(VoxelRange range, vec3 from, vec3 to, int max_steps, MarchBias bias) {
  const March m = march_between(from, to, max_steps, bias);
  const int words = int(range.slices / 32);
  for (int step = 0; step < m.steps; ++step) {
    const ivec2 slices = march_slices(range, m, step);
    const ivec2 pixel = march_pixel(m, step);
    // A step that passes more than two words, 64 slices, is tested at its ends.
    const ivec2 word = slices >> 5;
    const int column = pixel.y * words;
    const uint near = imageLoad(VOXELS, ivec2(pixel.x, column + word.x)).x;
    const uint far = imageLoad(VOXELS, ivec2(pixel.x, column + word.y)).x;
    if (((near & slice_mask(word.x, slices.x, slices.y)) |
         (far & slice_mask(word.y, slices.x, slices.y))) != 0)
      return 0.0;
  }
  return 1.0;
}

#undef MARCH
#undef VOXELS
