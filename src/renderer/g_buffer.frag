// SPDX-License-Identifier: MIT
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/material.glsl"
#include "shading/packing.h"

layout(set = 1, binding = 0) uniform sampler2D base_color_texture;
layout(set = 1, binding = 1) uniform sampler2D metallic_roughness_texture;
layout(set = 1, binding = 2) uniform sampler2D normal_texture;
layout(set = 1, binding = 3) uniform sampler2D emission_texture;

layout(location = 0) in vec3 normal_world;
layout(location = 1) in vec4 tangent_world;
layout(location = 2) in vec4 base_color_and_material_uv;
layout(location = 3) in vec4 clip_now;
layout(location = 4) in vec4 clip_before;
layout(location = 5) in vec4 vertex_color;
layout(location = 6) in vec4 normal_and_emission_uv;
layout(location = 7) flat in uint surface_bits_of_instance;
layout(location = 8) flat in uint object;

layout(location = 0) out vec4 base_color;  // alpha: InstanceData::object in 255ths
layout(location = 1) out vec2 normal;
layout(location = 2) out vec4 material;
layout(location = 3) out vec4 emission;
layout(location = 4) out vec2 motion;

void main() {
  const MaterialData m = materials.data[draw.material];
  const vec4 color =
      m.base_color * vertex_color * texture(base_color_texture, base_color_and_material_uv.xy);
  if (color.a < m.alpha_cutoff) discard;

  vec3 n = normalize(normal_world);
  if (m.has_normal_map != 0) {
    const vec3 t = normalize(tangent_world.xyz - n * dot(n, tangent_world.xyz));
    const vec3 b = cross(n, t) * tangent_world.w;
    vec3 mapped = texture(normal_texture, normal_and_emission_uv.xy).xyz * 2.0 - 1.0;
    mapped.xy *= m.normal_scale;
    const vec3 perturbed = t * mapped.x + b * mapped.y + n * mapped.z;
    // A degenerate tangent leaves the interpolated normal as it is.
    if (dot(perturbed, perturbed) > 1e-8) n = normalize(perturbed);
  }
  // A surface seen from behind is lit from behind.
  if (!gl_FrontFacing) n = -n;

  const vec4 mr = texture(metallic_roughness_texture, base_color_and_material_uv.zw);
  const bool lit = m.unlit == 0;
  base_color = vec4(lit ? color.rgb : vec3(0.0), float(object) / 255.0);
  normal = octahedral_encode(n);
  material.rgb = lit ? vec3(m.metallic * mr.b, m.roughness * mr.g, m.specular) : vec3(0.0);
  uint surface_bits = surface_bits_of_instance;
  if (m.cosine_lobe != 0u) {
    const uint index = m.cosine_lobe - 1u;
    surface_bits |= kHasCosineLobe | (index >> 8);
    material.b = float(index & 255u) / 255.0;
  }
  material.a = float(surface_bits) / 255.0;
  const vec3 emitted = m.emission * texture(emission_texture, normal_and_emission_uv.zw).rgb;
  emission = vec4(min(lit ? emitted : color.rgb, vec3(65504.0)), 1.0);
  motion = 0.5 * (clip_now.xy / clip_now.w - clip_before.xy / clip_before.w);
}
