// SPDX-License-Identifier: MIT
// LCM 5: radiance and distance of what a face shows, averaged over squares of pixels.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D source;
layout(set = 0, binding = 2) uniform sampler2D background;
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D texels;
layout(push_constant, scalar) uniform Push { TexelsParams p; };

void main() {
  const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, p.extent))) return;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < p.factor; ++y) {
    for (int x = 0; x < p.factor; ++x) {
      const ivec2 pixel = texel * p.factor + ivec2(x, y);
      const float d = texelFetch(depth, pixel, 0).r;
      if (d != p.screen.depth_of_nothing) {
        const vec3 ray = vec3(ray_through(p.screen, vec2(pixel) + 0.5), -1.0);
        const float distance_m = z_from_depth(p.screen, d) * length(ray);
        sum += vec4(texelFetch(source, pixel, 0).rgb, min(distance_m, p.far_m));
      } else {
        const vec3 radiance = texelFetch(background, pixel, 0).rgb;
        sum += vec4(p.has_background != 0 ? radiance : vec3(0.0), p.far_m);
      }
    }
  }
  imageStore(texels, p.corner + texel, sum / float(p.factor * p.factor));
}
