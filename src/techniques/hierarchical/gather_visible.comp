// SPDX-License-Identifier: MIT
// As gather.comp, but what is behind an obstacle gives nothing: v_i of FDP (3), by marching through
// the level's own voxels.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"
#include "voxels/slices.h"

layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D indirect;
layout(set = 0, binding = 3, r32ui) uniform readonly uimage2D voxels;
layout(set = 0, binding = 4, scalar) readonly buffer Range { VoxelRange value; } range;
layout(push_constant, scalar) uniform Push { GatherParams p; };
const uint march_rays = 1;

// Read once: a CPU reads a buffer lane by lane.
VoxelRange voxel_range;

#include "techniques/hierarchical/gather.glsl"
#include "techniques/hierarchical/own_view.glsl"
#include "voxels/march.glsl"

float visibility(Receiver r, ivec2 q, vec4 surface) {
  return march(voxel_range, vec3(r.at_px * p.march_scale, -r.position.z),
               vec3((vec2(q) + 0.5) * p.march_scale, surface.w), p.march_steps,
               MarchBias(kMarchBiasPx * p.march_scale, kMarchBiasSlices));
}

void main() {
  voxel_range = range.value;
  gather(p);
}
