// SPDX-License-Identifier: MIT
// The light that reaches each pixel of one level from the level's own ring, visibility 1.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D indirect;
layout(push_constant, scalar) uniform Push { GatherParams p; };
const uint march_rays = 0;

#include "techniques/hierarchical/gather.glsl"

Receiver receiver(ivec2 pixel) {
  const vec4 surface = imageLoad(geometry, pixel);
  const vec2 at_px = vec2(pixel) + 0.5;
  return Receiver(pixel, at_px, position_view(ray_through(p.screen, at_px), surface.w),
                  surface.xyz);
}

float visibility(Receiver r, ivec2 q, float z) { return 1.0; }

void keep(ivec2 pixel, vec4 light) { imageStore(indirect, pixel, min(light, vec4(65504.0))); }

void main() { gather(p); }
