// SPDX-License-Identifier: MIT
#include "image/flip_hdr.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "image/exposure.h"
#include "image/half.h"

namespace lueur {
namespace {

constexpr float kExposure = 0.6f;  // built into the curve's first two powers
constexpr float kA = 2.51f * kExposure * kExposure;
constexpr float kB = 0.03f * kExposure;
constexpr float kC = 2.43f * kExposure * kExposure;
constexpr float kD = 0.59f * kExposure;
constexpr float kE = 0.14f;

float tone_curve(float x) {
  return std::clamp((kA * x + kB) * x / ((kC * x + kD) * x + kE), 0.0f, 1.0f);
}

// The x that the curve takes to 0.85, the positive root of (a - tc) x^2 + (b - td) x - te = 0.
double shown_near_white() {
  constexpr double kShown = 0.85;
  constexpr double kSquare = kA - kShown * kC;
  constexpr double kHalfLinear = 0.5 * (kB - kShown * kD) / kSquare;
  return -kHalfLinear + std::sqrt(kHalfLinear * kHalfLinear + kShown * kE / kSquare);
}

float median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5f * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

FlipExposures flip_exposures(const ImageF& reference, const Mask* mask) {
  std::vector<float> luminances;
  const size_t pixels = size_t{reference.width} * reference.height;
  for (size_t i = 0; i < pixels; ++i)
    if (counts(mask, i)) luminances.push_back(luminance_at(reference, i));
  if (luminances.empty()) return {};
  const float brightest = *std::max_element(luminances.begin(), luminances.end());
  if (!(brightest > 0.0f)) return {};
  float middle = median(luminances);
  if (!(middle > 0.0f)) {
    std::erase_if(luminances, [](float y) { return !(y > 0.0f); });
    middle = median(std::move(luminances));
  }

  FlipExposures exposures;
  const double shown = shown_near_white();
  exposures.start_ev = static_cast<float>(std::log2(shown / static_cast<double>(brightest)));
  exposures.stop_ev = static_cast<float>(std::log2(shown / static_cast<double>(middle)));
  const float stops = std::ceil(exposures.stop_ev - exposures.start_ev);
  exposures.count = std::max(2u, static_cast<uint32_t>(stops));
  return exposures;
}

ImageF flip_exposed(const ImageF& image, float exposure_ev) {
  const float scale = std::exp2(exposure_ev);
  ImageF shown = image;
  // Past the largest half the curve is at its end; larger values would only overflow.
  for (float& sample : shown.samples)
    sample = tone_curve(std::clamp(sample * scale, 0.0f, kLargestHalf));
  return shown;
}

ImageF hdr_flip_map(const ImageF& test, const ImageF& reference, const FlipExposures& exposures,
                    float pixels_per_degree) {
  LUEUR_CHECK_OP(exposures.count, >, 0u);
  ImageF largest(test.width, test.height, 1);
  const float step = exposures.count > 1 ? (exposures.stop_ev - exposures.start_ev) /
                                               static_cast<float>(exposures.count - 1)
                                         : 0.0f;
  for (uint32_t i = 0; i < exposures.count; ++i) {
    const float exposure_ev = exposures.start_ev + static_cast<float>(i) * step;
    const ImageF map = flip_map(flip_exposed(test, exposure_ev),
                                flip_exposed(reference, exposure_ev), pixels_per_degree);
    for (size_t pixel = 0; pixel < map.samples.size(); ++pixel)
      largest.samples[pixel] = std::max(largest.samples[pixel], map.samples[pixel]);
  }
  return largest;
}

}  // namespace lueur
