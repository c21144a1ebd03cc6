// SPDX-License-Identifier: MIT
// What the tests' shaders get from the CPU.
#ifndef LUEUR_VOXELS_TEST_SHADERS_PARAMS_H
#define LUEUR_VOXELS_TEST_SHADERS_PARAMS_H

#include "voxels/march.h"

LUEUR_NAMESPACE_BEGIN

struct MarchLine {
  vec3 from;  // see march.h
  vec3 to;
};

struct MarchParams {
  int lines;
  int max_steps;
  MarchBias bias;
};

LUEUR_NAMESPACE_END

#endif
