// SPDX-License-Identifier: MIT
// The least that a pipeline can be made from.
#version 460

layout(local_size_x = 1) in;
layout(set = 0, binding = 0) buffer Numbers { uint data[]; } numbers;

void main() { numbers.data[0] = 1u; }
