// SPDX-License-Identifier: MIT
// Which lobe each pixel of level 0 has: that of a pixel on the surface that the level keeps.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/params.h"

layout(constant_id = 0) const int factor = 2;
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D reflectance;
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 3, r16f) uniform writeonly image2D lobe;  // see lobe_of()
layout(push_constant, scalar) uniform Push { LobeParams p; };

#include "techniques/hierarchical/surface_pixel.glsl"

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const float z = imageLoad(geometry, pixel).w;
  const ivec2 child = pixel_of_surface(pixel, z, p.screen, p.full_extent);
  const float code = imageLoad(reflectance, child).a;
  imageStore(lobe, pixel, vec4(code < 0.0 ? 1.0 - code : code));
}
