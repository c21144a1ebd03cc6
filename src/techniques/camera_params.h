// SPDX-License-Identifier: MIT
// The camera, as passes over the pixels of its G-buffer need it.
#ifndef LUEUR_TECHNIQUES_CAMERA_PARAMS_H
#define LUEUR_TECHNIQUES_CAMERA_PARAMS_H

#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

struct CameraParams {
  Screen screen;
  mat3 view_from_world;
  ivec2 extent;  // pixels of the G-buffer
};

LUEUR_NAMESPACE_END

#endif
