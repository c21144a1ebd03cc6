// SPDX-License-Identifier: MIT
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;

layout(set = 0, binding = 0, scalar) uniform Params { GBufferParams value; } params;
layout(set = 0, binding = 1, scalar) readonly buffer Instances { InstanceData data[]; } instances;

layout(location = 0) out vec3 normal_world;
layout(location = 1) out vec4 tangent_world;
layout(location = 2) out vec2 texture_uv;
layout(location = 3) out vec4 clip_now;
layout(location = 4) out vec4 clip_before;

void main() {
  const InstanceData instance = instances.data[gl_InstanceIndex];
  const vec4 now = instance.world_from_object * vec4(position, 1.0);
  const vec4 before = instance.world_from_object_before * vec4(position, 1.0);
  normal_world = instance.world_from_object_normal * normal;
  tangent_world = vec4(mat3(instance.world_from_object) * tangent.xyz, tangent.w);
  texture_uv = uv;
  clip_now = params.value.clip_from_world * now;
  clip_before = params.value.clip_from_world_before * before;
  gl_Position = clip_now;
}
