// SPDX-License-Identifier: MIT
// Bits for integer targets.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "frame/test_shaders/params.h"

layout(set = 0, binding = 0, scalar) uniform Params { FillParams value; } params;
layout(location = 0) out uvec4 bits;

void main() { bits = uvec4(params.value.color); }
