// SPDX-License-Identifier: MIT
// final = direct + albedo * indirect + indirect specular + specular: HSSIL 4.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"

// Rows, as texel fetches like them; see prepare.comp of the hierarchical technique.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D albedo;
layout(set = 0, binding = 2, rgba16f) uniform readonly image2D specular;
layout(set = 0, binding = 3, rgba16f) uniform readonly image2D indirect;
layout(set = 0, binding = 4, rgba16f) uniform readonly image2D indirect_specular;
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D composed;
layout(push_constant, scalar) uniform Push { ComposeParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 direct = imageLoad(source, pixel);
  vec3 sum = direct.rgb + imageLoad(specular, pixel).rgb;
  if (p.has_indirect != 0) sum += imageLoad(albedo, pixel).rgb * imageLoad(indirect, pixel).rgb;
  if (p.has_indirect_specular != 0) sum += imageLoad(indirect_specular, pixel).rgb;
  imageStore(composed, pixel, vec4(min(sum, vec3(65504.0)), direct.a));
}
