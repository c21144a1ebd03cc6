// SPDX-License-Identifier: MIT
#version 460

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Numbers { uint data[]; } numbers;
layout(set = 0, binding = 1) buffer Doubled { uint data[]; } doubled;

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < numbers.data.length()) doubled.data[i] = 2u * numbers.data[i];
}
