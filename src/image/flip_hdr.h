// SPDX-License-Identifier: MIT
// HDR-FLIP, the largest difference that an observer perceives at any exposure: Andersson, Nilsson,
// Shirley, Akenine-Möller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics
// 2021 (short papers). Exposures and tone curve are those of version 1 of NVIDIA's tool with ACES.
#pragma once

#include <cstdint>

#include "image/flip.h"
#include "image/image.h"
#include "image/mask.h"

namespace lueur {

// `count` exposures from the first to the last stop, at equal distances.
struct FlipExposures {
  float start_ev = 0.0f;
  float stop_ev = 0.0f;
  uint32_t count = 1;
};

// From the exposure at which the reference's largest luminance is shown at 0.85, to that at which
// its median is; as many as there are stops between, 2 or more. Only pixels that count are metered.
// differs: where the median is black, the median of those above black stands in for it, and a
// reference without light gets the one exposure 0; the tool's range is infinite there.
FlipExposures flip_exposures(const ImageF& reference, const Mask* mask = nullptr);

// What the display shows at one exposure, linear in [0, 1]: (a x^2 + b x) / (c x^2 + d x + e),
// Krzysztof Narkowicz's fit of ACES (2015) with its exposure of 0.6. Negative samples count as 0.
ImageF flip_exposed(const ImageF& image, float exposure_ev);

// For each pixel the largest flip_map() over the exposures, in [0, 1]. The pictures are linear and
// scene-referred, of the same size, with 1, 3 or 4 channels. Symmetric but for the exposures, which
// come from the reference.
ImageF hdr_flip_map(const ImageF& test, const ImageF& reference, const FlipExposures& exposures,
                    float pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace lueur
