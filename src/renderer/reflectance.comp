// SPDX-License-Identifier: MIT
// What a technique needs to know of glossy surfaces: GBuffer::reflectance.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"
#include "shading/brdf.h"

// Rows, as texel fetches like them; see prepare.comp of the hierarchical technique.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D base_color;
layout(set = 0, binding = 1) uniform sampler2D material;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D reflectance;
layout(set = 0, binding = 3, scalar) readonly buffer Lobes { LobeData data[]; } lobes;
layout(push_constant, scalar) uniform Push { ReflectanceParams p; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec3 color = texelFetch(base_color, pixel, 0).rgb;
  const vec4 m = texelFetch(material, pixel, 0);
  vec4 result = vec4(specular_f0(color, m.r, m.b), m.g);
  if (has_cosine_lobe(m)) {
    const LobeData lobe = lobes.data[cosine_lobe_index(m)];
    result = vec4(lobe.color, lobe.name);
  }
  imageStore(reflectance, pixel, result);
}
