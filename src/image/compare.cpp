// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "base/check.h"

namespace lueur {
namespace {

std::string shape(const Image8& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height) + " with " +
         std::to_string(image.channels) + " channels";
}

}  // namespace

Result<Difference> compare(const Image8& a, const Image8& b, uint8_t tolerance) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    return Error{ErrorKind::input,
                 "the pictures cannot be compared: one is " + shape(a) + ", the other " + shape(b)};
  LUEUR_CHECK_OP(a.samples.size(), ==, size_t{a.width} * a.height * a.channels);
  LUEUR_CHECK_OP(a.samples.size(), ==, b.samples.size());
  if (a.samples.empty()) return Difference{};

  uint64_t pixels_over = 0;
  int max_channel = 0;
  for (size_t pixel = 0; pixel < a.samples.size(); pixel += a.channels) {
    int max_here = 0;
    for (size_t c = 0; c < a.channels; ++c) {
      const int difference = std::abs(int{a.samples[pixel + c]} - int{b.samples[pixel + c]});
      max_here = std::max(max_here, difference);
    }
    pixels_over += max_here > tolerance ? 1 : 0;
    max_channel = std::max(max_channel, max_here);
  }

  Difference result;
  const double samples = static_cast<double>(a.samples.size());
  result.share_over = static_cast<double>(pixels_over) * a.channels / samples;
  result.max_channel = static_cast<uint8_t>(max_channel);
  return result;
}

}  // namespace lueur
