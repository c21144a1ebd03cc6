// SPDX-License-Identifier: MIT
#version 460

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, r32ui) uniform writeonly uimage2D voxels;

void main() {
  const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(texel, imageSize(voxels)))) imageStore(voxels, texel, uvec4(0));
}
