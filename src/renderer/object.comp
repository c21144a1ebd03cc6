// SPDX-License-Identifier: MIT
// Gives techniques the moving object at each pixel: GBuffer::object.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"

// Rows, as texel fetches like them; see prepare.comp of the hierarchical technique.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D base_color;
layout(set = 0, binding = 1, r8) uniform writeonly image2D object;
layout(push_constant, scalar) uniform Push { ObjectParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  imageStore(object, pixel, vec4(texelFetch(base_color, pixel, 0).a));
}
