// SPDX-License-Identifier: MIT
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/material.glsl"
#include "renderer/texture_place.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec2 uv_2;
layout(location = 5) in vec4 color;

layout(set = 0, binding = 0, scalar) uniform Params { GBufferParams value; } params;
layout(set = 0, binding = 1, scalar) readonly buffer Instances { InstanceData data[]; } instances;
layout(set = 0, binding = 3, scalar) readonly buffer Deformed { DeformedVertex data[]; } deformed;

layout(location = 0) out vec3 normal_world;
layout(location = 1) out vec4 tangent_world;
layout(location = 2) out vec4 base_color_and_material_uv;
layout(location = 3) out vec4 clip_now;
layout(location = 4) out vec4 clip_before;
layout(location = 5) out vec4 vertex_color;
layout(location = 6) out vec4 normal_and_emission_uv;
layout(location = 7) flat out uint surface_bits_of_instance;
layout(location = 8) flat out uint object;

void main() {
  const InstanceData instance = instances.data[gl_InstanceIndex];
  DeformedVertex v = DeformedVertex(position, position, normal, tangent.xyz);
  if (instance.is_deformed != 0) v = deformed.data[gl_VertexIndex + instance.first_deformed];
  const vec4 now = instance.world_from_object * vec4(v.position, 1.0);
  const vec4 before = instance.world_from_object_before * vec4(v.position_before, 1.0);
  normal_world = instance.world_from_object_normal * v.normal;
  tangent_world = vec4(mat3(instance.world_from_object) * v.tangent, tangent.w);
  const MaterialData m = materials.data[draw.material];
  base_color_and_material_uv = vec4(placed(m.base_color_place, uv, uv_2),
                                    placed(m.metallic_roughness_place, uv, uv_2));
  normal_and_emission_uv =
      vec4(placed(m.normal_place, uv, uv_2), placed(m.emission_place, uv, uv_2));
  vertex_color = color;
  surface_bits_of_instance = instance.surface_bits;
  object = instance.object;
  clip_now = params.value.clip_from_world * now;
  clip_before = params.value.clip_from_world_before * before;
  gl_Position = clip_now;
}
