// SPDX-License-Identifier: MIT
// The next coarser level: solid is what is solid in all pixels below (FDP section 4). At an odd
// edge a pixel has fewer below it.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, r32ui) uniform readonly uimage2D fine;
layout(set = 0, binding = 1, r32ui) uniform writeonly uimage2D voxels;
layout(push_constant, scalar) uniform Push { LevelParams p; };

void main() {
  const int words = int(p.words);
  const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= p.extent.x || texel.y >= p.extent.y * words) return;
  const int word = texel.y % words;
  const ivec2 low = 2 * ivec2(texel.x, texel.y / words);
  const ivec2 high = min(low + 1, p.fine_extent - 1);
  const uint bits = imageLoad(fine, ivec2(low.x, low.y * words + word)).x &
                    imageLoad(fine, ivec2(high.x, low.y * words + word)).x &
                    imageLoad(fine, ivec2(low.x, high.y * words + word)).x &
                    imageLoad(fine, ivec2(high.x, high.y * words + word)).x;
  imageStore(voxels, texel, uvec4(bits));
}
