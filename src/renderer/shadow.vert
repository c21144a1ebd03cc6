// SPDX-License-Identifier: MIT
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;

layout(set = 0, binding = 0, scalar) uniform Params { ShadowParams value; } params;
layout(set = 0, binding = 1, scalar) readonly buffer Instances { InstanceData data[]; } instances;

layout(location = 0) out vec2 texture_uv;

void main() {
  texture_uv = uv;
  gl_Position = params.value.clip_from_world *
                (instances.data[gl_InstanceIndex].world_from_object * vec4(position, 1.0));
}
