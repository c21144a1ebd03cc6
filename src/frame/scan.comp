// SPDX-License-Identifier: MIT
// Counts the pixels of an image that cannot be light: NaN, infinite, negative.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "frame/scan_params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D image;
layout(set = 0, binding = 1, scalar) buffer Rows { ScanRow rows[]; } rows;
layout(push_constant, scalar) uniform Push { ScanParams push; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, push.extent))) return;
  vec4 value = texelFetch(image, pixel, 0);
  // Channels that the image does not have read as 0, 0, 1: they cannot raise an alarm.
  const uvec4 bits = floatBitsToUint(value);
  const uvec4 magnitude = bits & 0x7fffffffu;
  const bool is_nan = any(greaterThan(magnitude, uvec4(0x7f800000u)));
  const bool is_infinite = any(equal(magnitude, uvec4(0x7f800000u)));
  const bool is_negative =
      any(greaterThan(bits, uvec4(0x80000000u))) && !is_nan && push.allow_negative == 0;
  if (is_nan) atomicAdd(rows.rows[push.row].nan_pixels, 1u);
  if (is_infinite) atomicAdd(rows.rows[push.row].infinite_pixels, 1u);
  if (is_negative) atomicAdd(rows.rows[push.row].negative_pixels, 1u);
  // Stored inverted, so that rows start as zero and the first pixel in reading order wins.
  if (is_nan || is_infinite || is_negative)
    atomicMax(rows.rows[push.row].inverted_first_pixel, ~uint(pixel.y * push.extent.x + pixel.x));
}
