// SPDX-License-Identifier: MIT
// Glossy light with obstacles: what is hidden behind an object is not seen through it in the floor.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"
#include "voxels/slices.h"

layout(set = 0, binding = 5, r32ui) uniform readonly uimage2D voxels;
layout(set = 0, binding = 6, scalar) readonly buffer Range { VoxelRange value; } range;
const uint march_rays = 1;

#include "techniques/hierarchical/gather_glossy.glsl"
#include "voxels/march.glsl"

float visibility(vec2 at_px, float z, ivec2 q, float z_of_patch) {
  return march(range.value, vec3(at_px * p.march_scale, z),
               vec3((vec2(q) + 0.5) * p.march_scale, z_of_patch), p.march_steps,
               MarchBias(kMarchBiasPx * p.march_scale, kMarchBiasSlices));
}
