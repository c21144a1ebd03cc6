// SPDX-License-Identifier: MIT
// All lights for the pixels of the list.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;

#include "techniques/indirect_lights/params.h"
#include "techniques/surface.glsl"

layout(set = 0, binding = 2, scalar) readonly buffer Lights { IndirectLight data[]; } lights;
layout(set = 0, binding = 3, scalar) readonly buffer List { uint count; uint data[]; } list;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D diffuse;
layout(set = 0, binding = 5, scalar) uniform Params { RefineParams value; } params;

#include "techniques/indirect_lights/gather.glsl"

void main() {
  const RefineParams p = params.value;
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  const uint first = group * 64 * pixels_per_thread + gl_LocalInvocationIndex;
  const uint count = list.count;
  if (first >= count) return;
  Receivers r;
  ivec2 pixels[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const uint packed = list.data[min(first + 64 * k, count - 1)];
    pixels[k] = ivec2(packed & 0xffff, packed >> 16);
    const Surface s = surface_at(p.camera, pixels[k]);
    r.position[k] = s.position;
    r.normal[k] = s.normal;
  }
  gather(r, p.lights);
  for (uint k = 0; k < pixels_per_thread; ++k)
    if (first + 64 * k < count) imageStore(diffuse, pixels[k], vec4(r.light[k], 1.0));
}
