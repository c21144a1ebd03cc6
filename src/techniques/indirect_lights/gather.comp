// SPDX-License-Identifier: MIT
// All lights for each pixel, or for one of factor x factor.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;

#include "techniques/indirect_lights/params.h"
#include "techniques/surface.glsl"

layout(set = 0, binding = 2, scalar) readonly buffer Lights { IndirectLight data[]; } lights;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D diffuse;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D geometry;  // normal and z
layout(set = 0, binding = 5, scalar) uniform Params { GatherParams value; } params;

#include "techniques/indirect_lights/gather.glsl"

// Of the G-buffer: the middle of those that this one stands for.
ivec2 fine_pixel(GatherParams p, ivec2 pixel) {
  return min(pixel * p.factor + p.factor / 2, p.camera.extent - 1);
}

void main() {
  const GatherParams p = params.value;
  const ivec2 first = ivec2(gl_GlobalInvocationID.x, gl_WorkGroupID.y * pixels_per_thread);
  if (first.x >= p.extent.x) return;
  Receivers r;
  vec4 geometry_of[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = min(first + ivec2(0, k), p.extent - 1);
    const Surface s = surface_at(p.camera, fine_pixel(p, pixel));
    r.position[k] = s.position;
    r.normal[k] = s.is_there ? s.normal : vec3(0.0);
    geometry_of[k] = s.is_there ? vec4(s.normal, -s.position.z) : vec4(0.0);
  }
  gather(r, p.lights);
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first + ivec2(0, k);
    if (pixel.y >= p.extent.y) break;
    imageStore(diffuse, pixel, vec4(geometry_of[k].w > 0.0 ? r.light[k] : vec3(0.0), 1.0));
    imageStore(geometry, pixel, geometry_of[k]);
  }
}
