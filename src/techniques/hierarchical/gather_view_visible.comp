// SPDX-License-Identifier: MIT
// As gather_view.comp, but what is behind an obstacle gives nothing, as far as the giving view's
// voxels tell: outside of that view all is free.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"
#include "voxels/slices.h"

layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;  // of the view that gives
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D receivers;
layout(set = 0, binding = 3, rgba16f) uniform image2D indirect;
layout(set = 0, binding = 4, scalar) uniform Params { GatherViewParams value; } params;
layout(set = 0, binding = 5, r32ui) uniform readonly uimage2D voxels;
layout(set = 0, binding = 6, scalar) readonly buffer Range { VoxelRange value; } range;
const uint march_rays = 1;

#include "techniques/hierarchical/gather.glsl"
#include "techniques/hierarchical/other_view.glsl"
#include "voxels/march.glsl"

// Both ends are moved into the air in front of their surfaces: towards the eye, or away from it
// where the view would see the receiver's back.
float visibility(Receiver r, ivec2 q, float z) {
  if (r.position.z > -1.0e-3) return 1.0;
  const float bias_m = kMarchBiasSlices / range.value.slices_per_m;
  const float side = dot(r.normal, r.position) < 0.0 ? -1.0 : 1.0;
  const float scale = params.value.gather.march_scale;
  return march(range.value, vec3(r.at_px * scale, max(-r.position.z + side * bias_m, 1.0e-3)),
               vec3((vec2(q) + 0.5) * scale, z - bias_m), params.value.gather.march_steps,
               MarchBias(kMarchBiasPx * scale, 0.0));
}

void main() { gather(params.value.gather); }
