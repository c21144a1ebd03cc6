// SPDX-License-Identifier: MIT
// An empty list.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) buffer List { uint count; uint data[]; } list;

void main() { list.count = 0; }
