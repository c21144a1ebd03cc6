// SPDX-License-Identifier: MIT
// How many workgroups take all entries of a list.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(constant_id = 0) const uint entries_per_group = 64;
layout(constant_id = 1) const uint capacity = 0xffffffffu;
// As many workgroups as a device takes in a row, at least.
const uint kMostInARow = 32768;
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) readonly buffer List { uint count; uint data[]; } list;
layout(set = 0, binding = 1, scalar) buffer Groups { uvec3 count; } groups;

void main() {
  const uint count = min(list.count, capacity);
  const uint all = (count + entries_per_group - 1) / entries_per_group;
  const uint rows = (all + kMostInARow - 1) / kMostInARow;
  groups.count = uvec3(min(all, kMostInARow), rows, 1);
}
