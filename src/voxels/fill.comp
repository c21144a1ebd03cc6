// SPDX-License-Identifier: MIT
// Makes solid columns of crossings: a voxel is solid if there is an odd number of them up to it.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, r32ui) uniform uimage2D voxels;
layout(push_constant, scalar) uniform Push { FillParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  uint inside = 0;  // all bits: the word before ended within a solid
  for (uint word = 0; word < p.words; ++word) {
    const ivec2 texel = ivec2(pixel.x, pixel.y * int(p.words) + int(word));
    uint bits = imageLoad(voxels, texel).x;
    bits ^= bits << 1;
    bits ^= bits << 2;
    bits ^= bits << 4;
    bits ^= bits << 8;
    bits ^= bits << 16;
    bits ^= inside;
    imageStore(voxels, texel, uvec4(bits));
    inside = uint(int(bits) >> 31);
  }
}
