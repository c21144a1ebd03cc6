// SPDX-License-Identifier: MIT
// One material: its numbers from the frame's buffer, its textures from descriptor set 1.
#include "renderer/params.h"

layout(set = 0, binding = 2, scalar) readonly buffer Materials { MaterialData data[]; } materials;
layout(push_constant, scalar) uniform Push { DrawParams draw; };
layout(set = 1, binding = 0) uniform sampler2D base_color_texture;
