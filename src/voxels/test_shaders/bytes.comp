// SPDX-License-Identifier: MIT
// Words as their four bytes, which a float can hold.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, r32ui) uniform readonly uimage2D words;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D bytes;

void main() {
  const ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(words)))) return;
  const uint word = imageLoad(words, texel).x;
  imageStore(bytes, texel, vec4((uvec4(word) >> uvec4(0, 8, 16, 24)) & 255u));
}
