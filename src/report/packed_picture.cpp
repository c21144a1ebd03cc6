// SPDX-License-Identifier: MIT
#include "report/packed_picture.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "image/half.h"
#include "report/text.h"

namespace lueur::report {
namespace {

// Codes, or differences of codes, of one channel.
using Plane = std::vector<int>;

Plane codes_of(const ImageF& image, uint32_t channel) {
  Plane codes;
  codes.reserve(size_t{image.width} * image.height);
  for (size_t i = channel; i < image.samples.size(); i += image.channels)
    codes.push_back(picture_code(image.samples[i]));
  return codes;
}

// The plane through the three neighbours, bounded by the left and the upper one, so that an edge
// does not overshoot: the median edge detector of LOCO-I. Neighbours outside count as the nearest
// one inside, the first of all as 0.
int predicted(const Plane& plane, size_t x, size_t y, size_t width) {
  const size_t i = y * width + x;
  if (x == 0) return y == 0 ? 0 : plane[i - width];
  const int left = plane[i - 1];
  if (y == 0) return left;
  const int above = plane[i - width];
  const auto [low, high] = std::minmax(left, above);
  return std::clamp(left + above - plane[i - width - 1], low, high);
}

// Appends what prediction misses.
void append_residuals(const Plane& plane, size_t width, std::vector<uint8_t>& bytes) {
  const size_t count = plane.size();
  const size_t start = bytes.size();
  bytes.resize(start + 2 * count);
  for (size_t i = 0; i < count; ++i) {
    const int miss = plane[i] - predicted(plane, i % width, i / width, width);
    const uint32_t folded = miss < 0 ? static_cast<uint32_t>(-miss) * 2 - 1 : miss * 2u;
    bytes[start + i] = static_cast<uint8_t>(folded);
    bytes[start + count + i] = static_cast<uint8_t>(folded >> 8);
  }
}

std::vector<uint8_t> deflated(const std::vector<uint8_t>& bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<uint8_t> packed(size);
  const int status = compress2(packed.data(), &size, bytes.data(), bytes.size(), 6);
  LUEUR_CHECK_OP(status, ==, Z_OK);  // the buffer is large enough by compressBound()
  packed.resize(size);
  return packed;
}

}  // namespace

uint16_t picture_code(float value) {
  const float bounded = value > 0.0f ? std::min(value, kLargestHalf) : 0.0f;
  const uint32_t rounded = (half_from_float(bounded) + (1u << (kDroppedBits - 1))) >> kDroppedBits;
  constexpr uint32_t kInfinity = 0x7c00u >> kDroppedBits;
  return static_cast<uint16_t>(std::min(rounded, kInfinity - 1));
}

PackedPicture pack_picture(const ImageF& image) {
  LUEUR_CHECK(image.channels == 1 || image.channels == 3);
  LUEUR_CHECK_OP(image.samples.size(), ==, size_t{image.width} * image.height * image.channels);
  PackedPicture packed;
  packed.replaced = static_cast<uint64_t>(std::ranges::count_if(
      image.samples, [](float value) { return !std::isfinite(value) || value < 0.0f; }));

  std::vector<uint8_t> bytes;
  bytes.reserve(image.samples.size() * 2);
  const Plane green = codes_of(image, image.channels == 1 ? 0 : 1);
  append_residuals(green, image.width, bytes);
  for (const uint32_t channel : {0u, 2u}) {
    if (image.channels == 1) break;
    Plane difference = codes_of(image, channel);
    std::ranges::transform(difference, green, difference.begin(), std::minus<>());
    append_residuals(difference, image.width, bytes);
  }
  packed.base64 = base64(deflated(bytes));
  return packed;
}

}  // namespace lueur::report
