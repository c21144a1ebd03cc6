// SPDX-License-Identifier: MIT
// Whether two stored pictures are the same up to rounding; the measure of the golden images. How
// far apart two pictures are that should differ is told by picture_error.h.
#pragma once

#include <cstdint>

#include "image/image.h"
#include "lueur/result.h"

namespace lueur {

struct Difference {
  double share_over = 0.0;  // pixels with a channel that differs by more than the tolerance, 0 to 1
  uint8_t max_channel = 0;  // the largest difference of any channel, in code values
};

// Compares two pictures channel by channel, alpha included. `tolerance` is in code values. Fails
// (ErrorKind::input) when the pictures differ in size or number of channels. Two empty pictures are
// equal.
Result<Difference> compare(const Image8& a, const Image8& b, uint8_t tolerance);

}  // namespace lueur
