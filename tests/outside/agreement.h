// SPDX-License-Identifier: MIT
// Whether two renderers that are both noisy agree: their difference against their own noise.
#pragma once

#include <string>

#include "image/image.h"

namespace lueur {

// Two renderings of one picture by one renderer that differ by their seeds alone. Their mean is its
// answer, and half their difference is a sample of that mean's error.
struct TwoSeeds {
  ImageF a, b;
};

// All of it over every pixel and channel, and in shares of the second renderer's mean.
struct Agreement {
  double mean = 0;            // of the first renderer, in its own units
  double bias = 0;            // of the first against the second
  double standard_error = 0;  // of `bias`, from the noise of both
  double rmse = 0;            // root of the mean squared difference of pixels
  double noise = 0;           // what `rmse` is from noise alone
  // Mean differences of squares of 8 x 8 pixels, each over its own standard error: the root of
  // their mean square, 1 where nothing but noise differs, and the greatest.
  double square_z = 0;
  double greatest_square_z = 0;
};

// The pictures have one size, in whole squares, and three channels. Noise is taken as independent
// from pixel to pixel; squares without any noise are left out of the last two figures.
Agreement agreement(const TwoSeeds& first, const TwoSeeds& second);

std::string to_string(const Agreement& a);

}  // namespace lueur
