// SPDX-License-Identifier: MIT
// Filters a picture of one channel along its rows or columns.
#pragma once

#include <span>

#include "image/image.h"

namespace lueur {

// out(x) = sum over k of kernel[k] * in(x + k - radius), where the kernel has 2 * radius + 1
// weights: a correlation, the kernel is not turned round. The outermost pixels repeat beyond the
// border.
ImageF filtered_along_x(const ImageF& plane, std::span<const float> kernel);
ImageF filtered_along_y(const ImageF& plane, std::span<const float> kernel);

}  // namespace lueur
