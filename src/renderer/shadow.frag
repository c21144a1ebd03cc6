// SPDX-License-Identifier: MIT
// Only for alpha-masked materials: holes cast no shadow.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/material.glsl"

layout(set = 1, binding = 0) uniform sampler2D base_color_texture;

layout(location = 0) in vec2 base_color_uv;
layout(location = 1) in vec4 vertex_color;

void main() {
  const MaterialData m = materials.data[draw.material];
  const float alpha =
      m.base_color.a * vertex_color.a * texture(base_color_texture, base_color_uv).a;
  if (alpha < m.alpha_cutoff) discard;
}
