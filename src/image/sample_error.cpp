// SPDX-License-Identifier: MIT
#include "image/sample_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace lueur {
namespace {

constexpr double kFloor = 0.01;  // e over the mean square of the reference

double square(double value) {
  return value * value;
}

uint32_t colour_channels(const ImageF& image) {
  return std::min(image.channels, 3u);
}

// Calls visit(t, r, pixel) for each colour sample that counts.
template <class Visit>
void for_each_sample(const ImageF& test, const ImageF& reference, const Mask* mask, Visit visit) {
  LUEUR_CHECK_OP(test.samples.size(), ==, reference.samples.size());
  LUEUR_CHECK_OP(test.channels, ==, reference.channels);
  const size_t pixels = size_t{test.width} * test.height;
  const uint32_t channels = colour_channels(test);
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    if (!counts(mask, pixel)) continue;
    for (size_t c = 0; c < channels; ++c) {
      const size_t i = pixel * test.channels + c;
      visit(static_cast<double>(test.samples[i]), static_cast<double>(reference.samples[i]), pixel);
    }
  }
}

struct Sums {
  double samples = 0.0;
  double t = 0.0, r = 0.0;
  double tt = 0.0, rr = 0.0, tr = 0.0;
};

Sums sums_of(const ImageF& test, const ImageF& reference, const Mask* mask) {
  Sums sums;
  for_each_sample(test, reference, mask, [&](double t, double r, size_t) {
    sums.samples += 1.0;
    sums.t += t;
    sums.r += r;
    sums.tt += t * t;
    sums.rr += r * r;
    sums.tr += t * r;
  });
  return sums;
}

double relative_square(double t, double r, double floor) {
  return relative(square(t - r), r * r + floor);
}

}  // namespace

double relative(double numerator, double denominator) {
  if (denominator != 0.0) return numerator / denominator;
  return numerator == 0.0 ? 0.0 : std::copysign(std::numeric_limits<double>::infinity(), numerator);
}

SampleErrors sample_errors(const ImageF& test, const ImageF& reference, const Mask* mask) {
  SampleErrors errors;
  const Sums sums = sums_of(test, reference, mask);
  if (sums.samples == 0.0) return errors;
  errors.bias = relative(sums.t - sums.r, sums.r);
  if (sums.tt > 0.0) errors.scale = sums.tr / sums.tt;

  // The squares need a pass of their own: as differences of the sums above they would drown in
  // rounding when the pictures are close.
  const double floor = kFloor * sums.rr / sums.samples;
  double squares = 0.0, relative_squares = 0.0, scaled_squares = 0.0;
  for_each_sample(test, reference, mask, [&](double t, double r, size_t) {
    squares += square(t - r);
    relative_squares += relative_square(t, r, floor);
    scaled_squares += square(errors.scale * t - r);
  });
  errors.rmse = std::sqrt(squares / sums.samples);
  errors.rel_mse = relative_squares / sums.samples;
  errors.rmse_scaled = std::sqrt(scaled_squares / sums.samples);
  return errors;
}

ImageF relative_error_map(const ImageF& test, const ImageF& reference, const Mask* mask) {
  const Sums sums = sums_of(test, reference, mask);
  ImageF map(test.width, test.height, 1);
  if (sums.samples == 0.0) return map;
  const double floor = kFloor * sums.rr / sums.samples;
  const double channels = colour_channels(test);
  for_each_sample(test, reference, mask, [&](double t, double r, size_t pixel) {
    map.samples[pixel] += static_cast<float>(relative_square(t, r, floor) / channels);
  });
  for (float& value : map.samples) value = std::sqrt(value);
  return map;
}

double psnr_db(double rmse, double peak) {
  return 20.0 * std::log10(relative(peak, rmse));
}

}  // namespace lueur
