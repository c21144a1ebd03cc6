// SPDX-License-Identifier: MIT
// IEEE 754 binary16, the sample type of most GPU images and of most EXR channels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lueur {

inline constexpr float kLargestHalf = 65504.0f;

// Rounds to the nearest half, ties to even. A value of more than 65519 becomes infinity, one of
// less than 2^-25 zero; NaN stays NaN.
uint16_t half_from_float(float value);

// Exact: every half is a float.
float float_from_half(uint16_t bits);

std::vector<float> floats_from_halves(std::span<const uint16_t> halves);

}  // namespace lueur
