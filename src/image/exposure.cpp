// SPDX-License-Identifier: MIT
#include "image/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"

namespace lueur {
namespace {

constexpr double kMiddleGrey = 0.18;
constexpr double kBrightestWhite = 4.0;

// The luminances that can be metered, in the order of the pixels.
std::vector<float> lit_luminances(const ImageF& image) {
  LUEUR_CHECK(image.channels == 1 || image.channels == 3 || image.channels == 4);
  std::vector<float> lit;
  const size_t pixels = image.samples.size() / image.channels;
  lit.reserve(pixels);
  for (size_t i = 0; i < pixels; ++i) {
    const float y = luminance_at(image, i);
    if (std::isfinite(y) && y > 0.0f) lit.push_back(y);
  }
  return lit;
}

}  // namespace

float auto_exposure_ev(const ImageF& image) {
  std::vector<float> lit = lit_luminances(image);
  if (lit.empty()) return 0.0f;

  // Average the logarithms: a few bright pixels must not darken the rest.
  double log2_sum = 0.0;
  for (const float y : lit) log2_sum += std::log2(static_cast<double>(y));
  const double average_ev = std::log2(kMiddleGrey) - log2_sum / static_cast<double>(lit.size());

  // Hold the highlights: a picture that is mostly shadow would burn out its lit part otherwise.
  const size_t rank = (lit.size() - 1) * 99 / 100;
  std::ranges::nth_element(lit, lit.begin() + static_cast<std::ptrdiff_t>(rank));
  const double highlight_ev = std::log2(kBrightestWhite / static_cast<double>(lit[rank]));
  return static_cast<float>(std::min(average_ev, highlight_ev));
}

}  // namespace lueur
