// SPDX-License-Identifier: MIT
// Starts the light targets: emission is the first source radiance, or the first specular one where
// an object passes no light on; and writes the diffuse albedo that the composition multiplies
// indirect light with.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"
#include "shading/brdf.h"

// Rows, as texel fetches like them; see prepare.comp of the hierarchical technique.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D base_color;
layout(set = 0, binding = 1) uniform sampler2D material;
layout(set = 0, binding = 2) uniform sampler2D emission;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D albedo;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D source;
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D specular;
layout(push_constant, scalar) uniform Push { SurfaceParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec3 color = texelFetch(base_color, pixel, 0).rgb;
  const vec4 m = texelFetch(material, pixel, 0);
  const vec4 emission_here = texelFetch(emission, pixel, 0);  // alpha: 1 on surfaces
  imageStore(albedo, pixel, vec4(diffuse_albedo(color, m.r), emission_here.a));
  const vec3 emitted = p.has_emission != 0 ? emission_here.rgb : vec3(0.0);
  const bool keeps = keeps_light(m);
  imageStore(source, pixel, vec4(keeps ? vec3(0.0) : emitted, emission_here.a));
  imageStore(specular, pixel, vec4(keeps ? emitted : vec3(0.0), 0.0));
}
