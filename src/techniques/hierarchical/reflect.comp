// SPDX-License-Identifier: MIT
// What surfaces radiate of the light that they have received: the source of the next bounce. With
// E/pi in `light` it is albedo * light.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D albedo;
layout(set = 0, binding = 2, rgba16f) uniform readonly image2D light;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D source_out;
layout(push_constant, scalar) uniform Push { ReflectParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 own = imageLoad(source, pixel);
  const vec3 sum =
      p.own_weight * own.rgb + imageLoad(albedo, pixel).rgb * imageLoad(light, pixel).rgb;
  imageStore(source_out, pixel, vec4(min(sum, vec3(65504.0)), own.a));
}
