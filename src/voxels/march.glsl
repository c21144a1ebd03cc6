// SPDX-License-Identifier: MIT
// The walk of march.h. The shader that includes this declares the level's image as `voxels`:
//   layout(..., r32ui) uniform readonly uimage2D voxels;

#include "voxels/march.h"

// 1: nothing is between the points. 0: something is. For the points see march.h.
float march(VoxelRange range, vec3 from, vec3 to, int max_steps, MarchBias bias) {
  const March m = march_between(from, to, max_steps, bias);
  const int words = int(range.slices / 32);
  for (int step = 0; step < m.steps; ++step) {
    const ivec2 slices = march_slices(range, m, step);
    const ivec2 pixel = march_pixel(m, step);
    for (int word = slices.x >> 5; word <= slices.y >> 5; ++word) {
      const uint bits = imageLoad(voxels, ivec2(pixel.x, pixel.y * words + word)).x;
      if ((bits & slice_mask(word, slices.x, slices.y)) != 0) return 0.0;
    }
  }
  return 1.0;
}
