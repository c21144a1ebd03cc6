// SPDX-License-Identifier: MIT
// Shows a number as a colour.
#pragma once

#include <array>
#include <cstdint>

#include "image/image.h"

namespace lueur {

// The sRGB code values of matplotlib's magma (Nathaniel Smith and Stéfan van der Walt, 2015, CC0),
// black at 0 over violet and orange to a pale yellow at 1, ever lighter: also readable in grey and
// by most who see few colours. Within 1 code value of the original's 256 entries. What is below 0
// counts as 0, above 1 as 1, NaN as 0.
std::array<uint8_t, 3> magma(float value);

// A picture of one channel by that map, 3 channels.
Image8 in_magma(const ImageF& plane);

}  // namespace lueur
