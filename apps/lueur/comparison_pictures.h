// SPDX-License-Identifier: MIT
// Pictures that differ by their indirect light or occlusion alone, and how far they are apart.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "frame/recorder.h"
#include "image/mask.h"
#include "reference/reference.h"
#include "report/comparison.h"

namespace lueur::cli {

// The reference's indirect light in the renderer's picture: direct + albedo * indirect +
// indirect_specular, with `direct` and `albedo` of the rendered frame. So what differs from a
// technique's picture is the indirect light, and not a shadow's edge. Where there is no surface it
// is the rendered frame. `rendered` has the images source, specular, albedo, depth and composed.
// A reference of occlusion has nothing but that.
report::Pictures pictures_of(const reference::Rendering& rendering,
                             std::span<const Pixels> rendered);

// A technique's frame: composed, its indirect light, and its occlusion if it gives any. For a frame
// without a technique, indirect light is black and all is open.
report::Pictures pictures_of(std::span<const Pixels> rendered);

// source + specular
ImageF direct_of(std::span<const Pixels> rendered);

// The columns of the error tables: the standard ones, of the composed pictures, and of indirect
// light (E/pi) by itself indirect_rmse, indirect_rel_mse, indirect_bias and indirect_rmse_scaled,
// and of occlusion occlusion_rmse and occlusion_bias.
std::vector<report::Metric> comparison_metrics();

// Those of light, with maps of flip and of the relative error of indirect light; against a
// reference of occlusion those of occlusion, with a map of the difference, and none where the test
// has no occlusion. `surfaces` are the pixels that show one; the others do not count.
Result<report::Errors> errors_between(const report::Pictures& test,
                                      const report::Pictures& reference,
                                      const std::string& reference_label, const Mask& surfaces);

}  // namespace lueur::cli
