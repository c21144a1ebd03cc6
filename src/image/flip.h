// SPDX-License-Identifier: MIT
// LDR-FLIP, the difference that an observer perceives who flips between two pictures on a display:
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator
// for Alternating Images", HPG 2020, with the separable filters of version 1.
#pragma once

#include <vector>

#include "image/image.h"

namespace lueur {

// 0.7 m away from a screen that is 0.7 m and 3840 pixels wide: 3840 * pi / 180.
inline constexpr float kFlipPixelsPerDegree = 67.0206433f;

// For each pixel the perceived difference in [0, 1]: 0 for equal surroundings, near 1 for black
// against white. Computed as c^(1 - f): c is the distance of the colours (HyAB in Hunt-adjusted
// CIELAB) after both pictures were filtered by the eye's contrast sensitivity, f that of their
// edges and points. Symmetric in its arguments.
//
// Both pictures hold linear Rec.709 display light in [0, 1], have the same size and 1 channel
// (grey), 3 or 4, of which the fourth is left out. Fewer pixels per degree look closer.
ImageF flip_map(const ImageF& test, const ImageF& reference,
                float pixels_per_degree = kFlipPixelsPerDegree);

// The one-dimensional filters, each with 2 * radius + 1 weights; shown here for the tests.
struct FlipFilters {
  // Contrast sensitivity of the achromatic (y), red-green (cx) and blue-yellow channel. The latter
  // is the sum of two: cz1 along both axes plus cz2 along both axes.
  std::vector<float> y, cx, cz1, cz2;
  // A Gaussian, and its first and second derivative whose positive weights add up to 1 and whose
  // negative ones to -1.
  std::vector<float> gaussian, edge, point;
};
FlipFilters flip_filters(float pixels_per_degree);

}  // namespace lueur
