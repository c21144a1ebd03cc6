// SPDX-License-Identifier: MIT
// Marches between given points.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/test_shaders/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, r32ui) uniform readonly uimage2D voxels;
layout(set = 0, binding = 1, scalar) readonly buffer Range { VoxelRange value; } range;
layout(set = 0, binding = 2, scalar) readonly buffer Lines { MarchLine data[]; } lines;
layout(set = 0, binding = 3, r32f) uniform writeonly image2D visibility;
layout(push_constant, scalar) uniform Push { MarchParams p; };

#include "voxels/march.glsl"

void main() {
  const int i = int(gl_GlobalInvocationID.x);
  if (i >= p.lines) return;
  const MarchLine line = lines.data[i];
  imageStore(visibility, ivec2(i, 0),
             vec4(march(range.value, line.from, line.to, p.max_steps, p.bias)));
}
