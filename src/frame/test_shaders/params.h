// SPDX-License-Identifier: MIT
// What the tests' shaders get from the CPU.
#ifndef LUEUR_FRAME_TEST_SHADERS_PARAMS_H
#define LUEUR_FRAME_TEST_SHADERS_PARAMS_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

struct CopyParams {
  ivec2 extent;  // pixels
  float add;     // to every channel
};

struct FillParams {
  vec4 color;
  float depth;
};

LUEUR_NAMESPACE_END

#endif
