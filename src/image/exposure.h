// SPDX-License-Identifier: MIT
// Picks an exposure for a picture, as a camera's light meter would.
#pragma once

#include "image/image.h"

namespace lueur {

// Rec.709 luminance of a linear Rec.709 colour, in the unit of its channels.
inline float luminance(float red, float green, float blue) {
  return 0.2126f * red + 0.7152f * green + 0.0722f * blue;
}

// That of a pixel, counted row by row, of a picture with 3 or 4 channels; the sample of one with 1.
inline float luminance_at(const ImageF& image, size_t pixel) {
  const float* samples = &image.samples[pixel * image.channels];
  return image.channels == 1 ? samples[0] : luminance(samples[0], samples[1], samples[2]);
}

// The exposure, in stops to add, that brings the log-average luminance of a linear picture to 0.18.
// Only pixels whose luminance is finite and above 0 count. The exposure is lowered where needed to
// keep the 99th percentile of those pixels at or below 4 times white. 0 when no pixel counts.
// `image` has 1, 3 or 4 channels. The same picture always gives the same number.
float auto_exposure_ev(const ImageF& image);

}  // namespace lueur
