// SPDX-License-Identifier: MIT
#ifndef LUEUR_FRAME_SCAN_PARAMS_H
#define LUEUR_FRAME_SCAN_PARAMS_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

struct ScanRow {
  uint nan_pixels;
  uint infinite_pixels;
  uint negative_pixels;
  uint inverted_first_pixel;  // ~(y * width + x) of the first such pixel; 0: none
};

struct ScanParams {
  ivec2 extent;         // pixels
  uint row;             // where this image's counts go
  uint allow_negative;  // 1 for images that are not light, such as normals
};

LUEUR_NAMESPACE_END

#endif
