// SPDX-License-Identifier: MIT
// W(F) of the glossy light.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/warp.glsl"

layout(set = 0, binding = 7, r16f) uniform readonly image2D lobe;
layout(set = 0, binding = 8, scalar) readonly buffer Lobes { CosineLobeData data[]; } lobes;
#include "shading/lobe.glsl"

float exponent_at(ivec2 pixel) { return lobe_of(imageLoad(lobe, pixel).r).exponent; }
