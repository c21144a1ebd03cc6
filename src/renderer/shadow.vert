// SPDX-License-Identifier: MIT
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/material.glsl"
#include "renderer/texture_place.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec2 uv_2;
layout(location = 3) in vec4 color;

layout(set = 0, binding = 0, scalar) uniform Params { ShadowParams value; } params;
layout(set = 0, binding = 1, scalar) readonly buffer Instances { InstanceData data[]; } instances;
layout(set = 0, binding = 3, scalar) readonly buffer Deformed { DeformedVertex data[]; } deformed;

layout(location = 0) out vec2 base_color_uv;
layout(location = 1) out vec4 vertex_color;

void main() {
  const InstanceData instance = instances.data[gl_InstanceIndex];
  vec3 at = position;
  if (instance.is_deformed != 0)
    at = deformed.data[gl_VertexIndex + instance.first_deformed].position;
  base_color_uv = placed(materials.data[draw.material].base_color_place, uv, uv_2);
  vertex_color = color;
  gl_Position = params.value.clip_from_world * (instance.world_from_object * vec4(at, 1.0));
}
