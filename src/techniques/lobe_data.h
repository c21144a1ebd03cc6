// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "lueur/g_buffer.h"
#include "shading/cosine_lobe.h"

namespace lueur {

// Inputs::lobes for shaders. One entry at least, as a buffer is never empty.
inline std::vector<CosineLobeData> lobe_data(std::span<const CosineLobe> lobes) {
  std::vector<CosineLobeData> data;
  for (const CosineLobe& lobe : lobes) data.push_back({lobe.exponent, lobe.c_xy, lobe.c_z});
  if (data.empty()) data.push_back({1.0f, -1.0f, 1.0f});
  return data;
}

}  // namespace lueur
