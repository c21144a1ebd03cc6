// SPDX-License-Identifier: MIT
// Which pixels of a picture an error counts. Pixels that show nothing have no light to be wrong
// about and would only thin the error out.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace lueur {

struct Mask {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> counts;  // 1 or 0 for each pixel

  size_t pixel_count() const;  // pixels that count
};

// Counts the pixels in which a channel of `layer` is not 0: with a rendered `depth` or `normal`
// those that show a surface.
Mask mask_of(const ImageF& layer);

// Whether a pixel counts. No mask counts all of them. A given mask has the picture's size.
inline bool counts(const Mask* mask, size_t pixel) {
  return mask == nullptr || mask->counts[pixel] != 0;
}

// The mean of a picture of one channel over the pixels that count; 0 when none does.
double mean(const ImageF& plane, const Mask* mask);

}  // namespace lueur
