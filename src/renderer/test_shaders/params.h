// SPDX-License-Identifier: MIT
// What the shaders of the renderer's tests get from the CPU.
#ifndef LUEUR_RENDERER_TEST_SHADERS_PARAMS_H
#define LUEUR_RENDERER_TEST_SHADERS_PARAMS_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// A TriangleRange and its batch.
struct CornerParams {
  mat4 world_from_object;
  uint first_index;
  uint index_count;
  int vertex_offset;
  uint first_float;
  uint stride_floats;
};

LUEUR_NAMESPACE_END

#endif
