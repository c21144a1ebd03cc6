// SPDX-License-Identifier: MIT
// Albedo and emission as techniques get them in scenes with objects that pass no light on: black
// there. `source` is already.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D material;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D albedo;
layout(set = 0, binding = 2, rgba16f) uniform readonly image2D emission;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D albedo_passed_on;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D emission_passed_on;
layout(push_constant, scalar) uniform Push { PassedOnParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const float passes = keeps_light(texelFetch(material, pixel, 0)) ? 0.0 : 1.0;
  imageStore(albedo_passed_on, pixel, passes * imageLoad(albedo, pixel));
  imageStore(emission_passed_on, pixel, passes * imageLoad(emission, pixel));
}
