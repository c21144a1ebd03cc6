// SPDX-License-Identifier: MIT
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "frame/test_shaders/params.h"

layout(set = 0, binding = 0, scalar) uniform Params { FillParams value; } params;
layout(location = 0) out vec4 color;

void main() { color = params.value.color; }
