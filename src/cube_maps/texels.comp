// SPDX-License-Identifier: MIT
// LCM 5: radiance and distance of what a face shows, averaged over squares of pixels. A workgroup
// makes a texel.
// differs: where there is nothing, and no background, there is no distance to average.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/params.h"

const uint kThreads = 64;
layout(local_size_x = 64) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D source;
layout(set = 0, binding = 2) uniform sampler2D background;
layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D texels;
layout(push_constant, scalar) uniform Push { TexelsParams p; };

// Sums of radiance, and of distances and their number.
shared vec3 radiances[kThreads];
shared vec2 distances[kThreads];

void add_pixel(ivec2 pixel, inout vec3 radiance, inout vec2 distance_and_one) {
  const float d = texelFetch(depth, pixel, 0).r;
  if (d != p.screen.depth_of_nothing) {
    const vec3 ray = vec3(ray_through(p.screen, vec2(pixel) + 0.5), -1.0);
    radiance += texelFetch(source, pixel, 0).rgb;
    distance_and_one += vec2(min(z_from_depth(p.screen, d) * length(ray), p.far_m), 1.0);
  } else if (p.has_background != 0) {
    radiance += texelFetch(background, pixel, 0).rgb;
    distance_and_one += vec2(p.far_m, 1.0);
  }
}

void main() {
  const uint thread = gl_LocalInvocationIndex;
  const ivec2 texel = ivec2(gl_WorkGroupID.xy);
  vec3 radiance = vec3(0.0);
  vec2 distance_and_one = vec2(0.0);
  for (uint i = thread; i < p.factor * p.factor; i += kThreads)
    add_pixel(texel * int(p.factor) + ivec2(i % p.factor, i / p.factor), radiance,
              distance_and_one);
  radiances[thread] = radiance;
  distances[thread] = distance_and_one;
  barrier();
  for (uint half_way = kThreads / 2; half_way > 0; half_way /= 2) {
    if (thread < half_way) {
      radiances[thread] += radiances[thread + half_way];
      distances[thread] += distances[thread + half_way];
    }
    barrier();
  }
  if (thread != 0) return;
  const vec2 d = distances[0];
  imageStore(texels, p.corner + texel,
             vec4(radiances[0] / float(p.factor * p.factor), d.y > 0.0 ? d.x / d.y : p.far_m));
}
