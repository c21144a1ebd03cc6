// SPDX-License-Identifier: MIT
#include "image/half.h"

#include <half.h>

#include <algorithm>

namespace lueur {

uint16_t half_from_float(float value) {
  return Imath::half(value).bits();
}

float float_from_half(uint16_t bits) {
  Imath::half value;
  value.setBits(bits);
  return value;
}

std::vector<float> floats_from_halves(std::span<const uint16_t> halves) {
  std::vector<float> floats(halves.size());
  std::ranges::transform(halves, floats.begin(), float_from_half);
  return floats;
}

}  // namespace lueur
