// SPDX-License-Identifier: MIT
// Light from what another view sees: the same rings, around the place where the receiver would be
// seen in that view. Adds to what is there, so that views and levels follow each other.
//
// Rings tile the plane whatever their centre: a receiver that the view does not see, or that is
// behind it, takes the nearest pixel of the view's.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;  // of the view that gives
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D receivers;
layout(set = 0, binding = 3, rgba16f) uniform image2D indirect;
layout(set = 0, binding = 4, scalar) uniform Params { GatherViewParams value; } params;
const uint march_rays = 0;

#include "techniques/hierarchical/gather.glsl"
#include "techniques/hierarchical/other_view.glsl"

float visibility(Receiver r, ivec2 q, vec4 surface) { return 1.0; }

void main() { gather(params.value.gather); }
