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
#include "techniques/hierarchical/own_view.glsl"

float visibility(Receiver r, ivec2 q, vec4 surface) { return 1.0; }

void main() { gather(p); }
