// SPDX-License-Identifier: MIT
// The numbers of the drawn material, from the frame's buffer.
#include "renderer/params.h"

layout(set = 0, binding = 2, scalar) readonly buffer Materials { MaterialData data[]; } materials;
layout(push_constant, scalar) uniform Push { DrawParams draw; };
