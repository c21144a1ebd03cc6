// SPDX-License-Identifier: MIT
// The mean of what the maps gave, by their shares. Alpha tells whose map it was.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/cube_map/params.h"

layout(constant_id = 0) const uint has_objects = 1;
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D sum;
layout(set = 0, binding = 1) uniform sampler2D object;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D light;
layout(push_constant, scalar) uniform Push { FinishParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 s = imageLoad(sum, pixel);
  const bool is_object = has_objects == 1 && texelFetch(object, pixel, 0).r > 0.0;
  const vec3 mean = s.a > 0.0 ? min(s.rgb / s.a, vec3(65504.0)) : vec3(0.0);
  imageStore(light, pixel, vec4(mean, is_object ? 1.0 : 0.0));
}
