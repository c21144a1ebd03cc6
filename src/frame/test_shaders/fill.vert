// SPDX-License-Identifier: MIT
// A triangle over the left half of the image, at one depth.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "frame/test_shaders/params.h"

layout(set = 0, binding = 0, scalar) uniform Params { FillParams value; } params;

void main() {
  const vec2 corners[3] = vec2[](vec2(0, -3), vec2(-4, 1), vec2(0, 5));
  gl_Position = vec4(corners[gl_VertexIndex % 3], params.value.depth, 1.0);
}
