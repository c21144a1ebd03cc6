// SPDX-License-Identifier: MIT
// F_i = a W(F_(i-1)) + (1 - a) I_i: FDP (6).
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/params.h"

// 1: the last frame's light is brought into the range of this frame's 3 x 3 pixels.
layout(constant_id = 0) const uint clamp_history = 0;
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba16f) uniform readonly image2D light;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D warped;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D blended;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D history;  // a: frames in it
layout(push_constant, scalar) uniform Push { TemporalParams p; };

// Mean and spread of the 3 x 3 pixels, a little of both sides being noise.
vec3 in_range_of_neighbours(vec3 before, ivec2 pixel) {
  vec3 sum = vec3(0.0);
  vec3 squares = vec3(0.0);
  for (int i = 0; i < 9; ++i) {
    const ivec2 q = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), p.extent - 1);
    const vec3 l = imageLoad(light, q).rgb;
    sum += l;
    squares += l * l;
  }
  const vec3 mean = sum / 9.0;
  const vec3 spread = kClampSpread * sqrt(max(squares / 9.0 - mean * mean, vec3(0.0)));
  return clamp(before, mean - spread, mean + spread);
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 before = p.has_history == 1 ? imageLoad(warped, pixel) : vec4(0.0);
  const float a = before.a;
  if (p.has_light == 0) {
    imageStore(blended, pixel, vec4(before.rgb, 0.0));
    imageStore(history, pixel, vec4(before.rgb, a / (1.0 - a)));
    return;
  }
  const vec4 own = imageLoad(light, pixel);
  const vec3 kept =
      clamp_history == 1 ? in_range_of_neighbours(before.rgb, pixel) : before.rgb;
  const vec3 sum = mix(own.rgb, kept, a);
  imageStore(blended, pixel, vec4(sum, own.a));
  imageStore(history, pixel, vec4(sum, 1.0 / (1.0 - a)));
}
