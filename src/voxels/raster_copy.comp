// SPDX-License-Identifier: MIT
// Brings the columns of the raster voxelizer's targets to the layout of all grids.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, rgba32ui) uniform readonly uimage2D bits_0;
layout(set = 0, binding = 1, rgba32ui) uniform readonly uimage2D bits_1;
layout(set = 0, binding = 2, rgba32ui) uniform readonly uimage2D bits_2;
layout(set = 0, binding = 3, rgba32ui) uniform readonly uimage2D bits_3;
layout(set = 0, binding = 4, r32ui) uniform writeonly uimage2D voxels;
layout(push_constant, scalar) uniform Push { RasterCopyParams p; };

void store(ivec2 pixel, uint word, uint bits) {
  if (word < p.words)
    imageStore(voxels, ivec2(pixel.x, pixel.y * int(p.words) + int(word)), uvec4(bits));
}

void store_target(ivec2 pixel, uint word, uvec4 bits) {
  store(pixel, word, bits.x);
  store(pixel, word + 1, bits.y);
  store(pixel, word + 2, bits.z);
  store(pixel, word + 3, bits.w);
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  store_target(pixel, 0, imageLoad(bits_0, pixel));
  if (p.words > 4) store_target(pixel, 4, imageLoad(bits_1, pixel));
  if (p.words > 8) {
    store_target(pixel, 8, imageLoad(bits_2, pixel));
    store_target(pixel, 12, imageLoad(bits_3, pixel));
  }
}
