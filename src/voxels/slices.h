// SPDX-License-Identifier: MIT
// Where a voxel grid's slices lie in depth, and a column's bits. Compiles as C++ and as GLSL.
#ifndef LUEUR_VOXELS_SLICES_H
#define LUEUR_VOXELS_SLICES_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// The slices of a grid, all of the same depth: slice s holds z_near + [s, s + 1) / slices_per_m,
// where z is the distance along the optical axis. Written on the device, see VoxelGrid::range.
struct VoxelRange {
  float z_near;        // m
  float slices_per_m;  // slices a metre
  uint slices;         // 32, 64, 128, 256 or 512: 32 a word
};

// Where in the grid a depth is, in slices; the slice is its floor. Below 0 and from `slices` on it
// is in front of the grid or behind it.
LUEUR_SHARED float slice_place(VoxelRange range, float z) {
  return (z - range.z_near) * range.slices_per_m;
}

// Whether what triangles bound is thinner than a slice, so that a ray's two crossings would mostly
// cancel. So is what bounds nothing, with 0.
LUEUR_SHARED bool is_thin(VoxelRange range, float thickness_m) {
  return thickness_m * range.slices_per_m < 1.0f;
}

// The bits of slices `first` to `last` in a column's word. None if the word has none of them.
LUEUR_SHARED uint slice_mask(int word, int first, int last) {
  const int low = max(first - 32 * word, 0);
  const int high = min(last - 32 * word, 31);
  if (low > high) return 0u;
  return (0xffffffffu << uint(low)) & (0xffffffffu >> uint(31 - high));
}

LUEUR_NAMESPACE_END

#endif
