// SPDX-License-Identifier: MIT
#include "image/mask.h"

#include <algorithm>

#include "base/check.h"

namespace lueur {

size_t Mask::pixel_count() const {
  return static_cast<size_t>(std::count(counts.begin(), counts.end(), uint8_t{1}));
}

Mask mask_of(const ImageF& layer) {
  Mask mask{layer.width, layer.height, {}};
  mask.counts.reserve(size_t{layer.width} * layer.height);
  for (size_t i = 0; i < layer.samples.size(); i += layer.channels) {
    const float* pixel = &layer.samples[i];
    mask.counts.push_back(
        std::any_of(pixel, pixel + layer.channels, [](float v) { return v != 0.0f; }) ? 1 : 0);
  }
  return mask;
}

double mean(const ImageF& plane, const Mask* mask) {
  LUEUR_CHECK_OP(plane.channels, ==, 1u);
  double sum = 0.0;
  size_t pixels = 0;
  for (size_t i = 0; i < plane.samples.size(); ++i) {
    if (!counts(mask, i)) continue;
    sum += static_cast<double>(plane.samples[i]);
    ++pixels;
  }
  return pixels == 0 ? 0.0 : sum / static_cast<double>(pixels);
}

}  // namespace lueur
