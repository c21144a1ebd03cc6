// SPDX-License-Identifier: MIT
// A cloud as pixels: position and radius, and beside it normal and 1; zeros behind the last one. The
// first row has the count.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "surfels/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, scalar) readonly buffer Surfels { uint count; Surfel data[]; } list;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D geometry;

void main() {
  const ivec2 size = imageSize(geometry);
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x >= size.x / 2 || pixel.y >= size.y) return;
  const uint index = uint((pixel.y - 1) * (size.x / 2) + pixel.x);
  vec4 a = vec4(list.count), b = vec4(0.0);
  if (pixel.y > 0) {
    const bool is_there = index < min(list.count, uint(list.data.length()));
    a = is_there ? vec4(list.data[index].position, list.data[index].radius_m) : vec4(0.0);
    b = is_there ? vec4(list.data[index].normal, 1.0) : vec4(0.0);
  }
  imageStore(geometry, ivec2(2 * pixel.x, pixel.y), a);
  imageStore(geometry, ivec2(2 * pixel.x + 1, pixel.y), b);
}
