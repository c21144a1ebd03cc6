// SPDX-License-Identifier: MIT
// Only for alpha-masked materials: holes cast no shadow.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/material.glsl"

layout(location = 0) in vec2 uv;

void main() {
  const MaterialData m = materials.data[draw.material];
  if ((m.base_color * texture(base_color_texture, uv)).a < m.alpha_cutoff) discard;
}
