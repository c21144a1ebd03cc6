// SPDX-License-Identifier: MIT
// The engine's G-buffer -> normal in view space and z of each pixel, all 0 where nothing is.
// Samples load it as a storage image, which costs less than two texel fetches, and is 0 outside.
#version 460
#extension GL_EXT_scalar_block_layout : require

// Rows, as texel fetches like them; see prepare.comp of the hierarchical technique.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;

#include "techniques/baselines/params.h"
#include "techniques/surface.glsl"

layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D geometry;
layout(push_constant, scalar) uniform Push { GeometryParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.camera.extent))) return;
  const Surface s = surface_at(p.camera, pixel);
  imageStore(geometry, pixel, s.is_there ? vec4(s.normal, -s.position.z) : vec4(0.0));
}
