// SPDX-License-Identifier: MIT
// Errors that compare sample with sample. t is a sample of the test picture, r that of the
// reference, and the mean goes over all colour samples (a fourth channel, coverage, is left out) of
// the pixels that count. All sums are in double precision.
#pragma once

#include "image/image.h"
#include "image/mask.h"

namespace lueur {

struct SampleErrors {
  // sqrt(mean((t - r)^2)): 0 or more, in the unit of the samples.
  double rmse = 0.0;

  // mean((t - r)^2 / (r^2 + e)) with e = 0.01 mean(r^2): 0 or more, without unit. The error
  // relative to what is there, so that a shadow weighs as much as a lamp; e keeps black pixels from
  // weighing without bound (no pixel weighs more than 100 times one at the root mean square) and
  // scales with the picture. After Rousselle et al. 2011, who add a fixed 0.01.
  double rel_mse = 0.0;

  // (mean(t) - mean(r)) / mean(r): signed, 0.1 means 10 % too bright.
  double bias = 0.0;

  // The factor s = sum(t r) / sum(t^2) that brings test closest to reference, and the rmse of s t
  // against r: what is wrong besides the brightness. A black test has s = 1.
  double rmse_scaled = 0.0;
  double scale = 1.0;
};

// Where the reference is black, the two relative errors are 0 when the test is black too, infinite
// otherwise. Both pictures have the same size and number of channels, and finite samples.
SampleErrors sample_errors(const ImageF& test, const ImageF& reference, const Mask* mask = nullptr);

// The root of a pixel's rel_mse (its mean over the channels) for every pixel, with the e of those
// that count; 0 where mask says no. The mean of its squares is `rel_mse`.
ImageF relative_error_map(const ImageF& test, const ImageF& reference, const Mask* mask = nullptr);

// Peak signal-to-noise ratio, 20 log10(peak / rmse), in dB; infinite for an rmse of 0.
double psnr_db(double rmse, double peak);

// numerator / denominator; 0 for 0 / 0, and infinite with the numerator's sign for x / 0.
double relative(double numerator, double denominator);

}  // namespace lueur
