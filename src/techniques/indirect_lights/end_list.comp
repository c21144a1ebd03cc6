// SPDX-License-Identifier: MIT
// How many workgroups take all pixels of the list.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(constant_id = 0) const uint pixels_per_group = 64;
// As many workgroups as a device takes in a row, at least.
const uint kMostInARow = 32768;
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) readonly buffer List { uint count; uint data[]; } list;
layout(set = 0, binding = 1, scalar) buffer Groups { uvec3 count; } groups;

void main() {
  const uint all = (list.count + pixels_per_group - 1) / pixels_per_group;
  const uint rows = (all + kMostInARow - 1) / kMostInARow;
  groups.count = uvec3(min(all, kMostInARow), rows, 1);
}
