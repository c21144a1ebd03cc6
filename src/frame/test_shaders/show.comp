// SPDX-License-Identifier: MIT
// A buffer as an image, row by row.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) readonly buffer Numbers { uint data[]; } numbers;
layout(set = 0, binding = 1, r32ui) uniform writeonly uimage2D shown;

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  const ivec2 extent = imageSize(shown);
  if (any(greaterThanEqual(pixel, extent))) return;
  imageStore(shown, pixel, uvec4(numbers.data[pixel.y * extent.x + pixel.x]));
}
