// SPDX-License-Identifier: MIT
// final = emission + occlusion * diffuse direct light + specular, for techniques that give
// occlusion and no light. What a surface emits itself, nothing around it darkens.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D emission;
layout(set = 0, binding = 2, rgba16f) uniform readonly image2D specular;
layout(set = 0, binding = 3, r16f) uniform readonly image2D occlusion;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D composed;
layout(push_constant, scalar) uniform Push { ComposeOccludedParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 direct = imageLoad(source, pixel);
  const vec3 sum = mix(imageLoad(emission, pixel).rgb, direct.rgb, imageLoad(occlusion, pixel).r) +
                   imageLoad(specular, pixel).rgb;
  imageStore(composed, pixel, vec4(min(sum, vec3(65504.0)), direct.a));
}
