// SPDX-License-Identifier: MIT
// What the passes that baselines share get from the CPU.
#ifndef LUEUR_TECHNIQUES_BASELINES_PARAMS_H
#define LUEUR_TECHNIQUES_BASELINES_PARAMS_H

#include "techniques/camera_params.h"

LUEUR_NAMESPACE_BEGIN

struct GeometryParams {
  CameraParams camera;
};

struct OcclusionParams {
  ivec2 extent;
};

LUEUR_NAMESPACE_END

#endif
