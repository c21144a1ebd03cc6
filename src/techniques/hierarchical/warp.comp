// SPDX-License-Identifier: MIT
// W(F) of the diffuse light.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/warp.glsl"

float exponent_at(ivec2 pixel) { return 1.0; }
