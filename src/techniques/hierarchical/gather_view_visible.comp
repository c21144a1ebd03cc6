// SPDX-License-Identifier: MIT
// As gather_view.comp, but what is behind an obstacle gives nothing, as far as the voxels of one
// view or the other tell: outside of both, all is free.
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
layout(set = 0, binding = 7, r32ui) uniform readonly uimage2D receiver_voxels;
layout(set = 0, binding = 8, scalar) readonly buffer ReceiverRange {
  VoxelRange value;
} receiver_range;
const uint march_rays = 1;

#include "techniques/hierarchical/gather.glsl"
#include "techniques/hierarchical/other_view.glsl"
#include "voxels/march.glsl"
#define MARCH march_among_receivers
#define VOXELS receiver_voxels
#include "voxels/march.glsl"

// A point of a surface moved into the air in front of it, along the normal: as far from its plane
// as some slices along the view's ray lead, and half a pixel across it, as columns are of pixels'
// centres. Along the ray itself it would be farther, and from a surface that the view sees the back
// of it would lead into what is behind.
vec3 in_air(vec3 position, vec3 normal, VoxelRange range, vec2 ray_scale) {
  const float along = dot(normal, normalize(position));
  const float across = sqrt(max(1.0 - along * along, 0.0));
  const float slice_m = 1.0 / range.slices_per_m;
  const float pixel_m = abs(position.z * ray_scale.y);
  return position +
         normal * (kMarchBiasSlices * slice_m * abs(along) + 0.5 * pixel_m * across);
}

// In the giving view, whose picture holds the patch.
float visibility_there(Receiver r, vec3 patch_position, vec3 patch_normal) {
  const GatherParams g = params.value.gather;
  Screen screen = g.screen;
  screen.ray_scale /= g.march_scale;
  const vec3 from = in_air(patch_position, patch_normal, range.value, screen.ray_scale);
  const vec3 to = in_air(r.position, r.normal, range.value, screen.ray_scale);
  return march(range.value, march_point(screen, from),
               march_end(screen, vec2(g.source_extent) * g.march_scale, from, to), g.march_steps,
               MarchBias(kMarchBiasPx * g.march_scale, 0.0));
}

// In the receivers' own view, whose picture holds the receiver.
float visibility_here(Receiver r, vec3 patch_position, vec3 patch_normal) {
  const mat4 there_from_here = params.value.source_from_receiver;
  const mat3 turn = transpose(mat3(there_from_here));
  const Screen screen = params.value.receiver_screen;
  const VoxelRange grid = receiver_range.value;
  const vec3 from = in_air(turn * (r.position - there_from_here[3].xyz), turn * r.normal, grid,
                           screen.ray_scale);
  const vec3 to = in_air(turn * (patch_position - there_from_here[3].xyz), turn * patch_normal,
                         grid, screen.ray_scale);
  return march_among_receivers(
      grid, march_point(screen, from),
      march_end(screen, vec2(params.value.gather.extent), from, to),
      params.value.gather.march_steps, MarchBias(kMarchBiasPx, 0.0));
}

float visibility(Receiver r, ivec2 q, vec4 surface) {
  const vec3 patch_position =
      position_view(ray_through(params.value.gather.screen, vec2(q) + 0.5), surface.w);
  if (visibility_there(r, patch_position, surface.xyz) == 0.0) return 0.0;
  return visibility_here(r, patch_position, surface.xyz);
}

void main() { gather(params.value.gather); }
