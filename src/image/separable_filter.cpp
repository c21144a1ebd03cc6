// SPDX-License-Identifier: MIT
#include "image/separable_filter.h"

#include <algorithm>
#include <vector>

#include "base/check.h"

namespace lueur {
namespace {

// Adds weight * from to a whole row: the one inner loop, which the compiler turns into vector
// instructions.
void add_weighted(float* to, const float* from, float weight, size_t count) {
  for (size_t i = 0; i < count; ++i) to[i] += weight * from[i];
}

void check(const ImageF& plane, std::span<const float> kernel) {
  LUEUR_CHECK_OP(plane.channels, ==, 1u);
  LUEUR_CHECK_OP(kernel.size() % 2, ==, 1u);
}

}  // namespace

ImageF filtered_along_x(const ImageF& plane, std::span<const float> kernel) {
  check(plane, kernel);
  ImageF result(plane.width, plane.height, 1);
  const size_t width = plane.width;
  const size_t radius = kernel.size() / 2;
  std::vector<float> padded(width + 2 * radius);
  for (size_t y = 0; y < plane.height; ++y) {
    const float* row = &plane.samples[y * width];
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width - 1]);
    for (size_t k = 0; k < kernel.size(); ++k)
      add_weighted(&result.samples[y * width], &padded[k], kernel[k], width);
  }
  return result;
}

ImageF filtered_along_y(const ImageF& plane, std::span<const float> kernel) {
  check(plane, kernel);
  ImageF result(plane.width, plane.height, 1);
  const size_t width = plane.width;
  const auto radius = static_cast<int64_t>(kernel.size() / 2);
  const int64_t last_row = int64_t{plane.height} - 1;
  for (int64_t y = 0; y <= last_row; ++y)
    for (size_t k = 0; k < kernel.size(); ++k) {
      const int64_t from = std::clamp(y + static_cast<int64_t>(k) - radius, int64_t{0}, last_row);
      add_weighted(&result.samples[static_cast<size_t>(y) * width],
                   &plane.samples[static_cast<size_t>(from) * width], kernel[k], width);
    }
  return result;
}

}  // namespace lueur
