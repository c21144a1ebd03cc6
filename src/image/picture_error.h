// SPDX-License-Identifier: MIT
// All errors of a picture against its reference in one go. What each of them means stands in
// sample_error.h, ssim.h, flip.h and flip_hdr.h; docs/metrics.md says when to read which.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "image/image.h"
#include "image/mask.h"
#include "lueur/result.h"

namespace lueur {

struct PictureErrors {
  // Of the samples as they are: linear and scene-referred, or for display-referred pictures
  // sRGB-encoded in [0, 1]. See SampleErrors.
  double rmse = 0.0;
  double rel_mse = 0.0;
  double bias = 0.0;
  double rmse_scaled = 0.0;
  double scale = 1.0;

  double psnr = 0.0;  // dB, of what a display shows, peak 1; infinite when nothing differs there
  double ssim = 1.0;  // mean of ssim_map() of what a display shows, on Rec.709 luma
  double flip = 0.0;  // mean of flip_map(), or of hdr_flip_map() for scene-referred pictures

  // One channel, over all pixels; what the means above were taken of.
  ImageF flip_map;
  ImageF ssim_map;
  ImageF relative_map;  // relative_error_map()
};

// The numbers of PictureErrors by name.
struct ErrorMetric {
  std::string_view name;
  double PictureErrors::*value;
  bool is_error;  // 0 is best, and less in magnitude is better
  std::string_view summary;
};
inline constexpr std::array<ErrorMetric, 8> kErrorMetrics = {{
    {"flip", &PictureErrors::flip, true, "perceived difference, 0 to 1"},
    {"rmse", &PictureErrors::rmse, true, "root mean square error, in the samples' unit"},
    {"rel_mse", &PictureErrors::rel_mse, true, "mean squared error relative to the reference"},
    {"bias", &PictureErrors::bias, true, "0.1: 10 % too bright, -0.1: too dark"},
    {"rmse_scaled", &PictureErrors::rmse_scaled, true, "rmse after the best scale factor"},
    {"scale", &PictureErrors::scale, false, "that factor on the test picture"},
    {"psnr", &PictureErrors::psnr, false, "peak signal-to-noise ratio in dB, more is closer"},
    {"ssim", &PictureErrors::ssim, false, "structural similarity, 1 is equal"},
}};

// Scene-referred pictures: linear, 1 or 3 channels, or 4 of which the fourth is left out. For psnr
// and ssim a display shows both at the reference's auto_exposure_ev() through
// ToneMap::khronos_neutral, in 8 bits.
//
// Fails (ErrorKind::input) when sizes or channels differ, a picture is empty or has a NaN or
// infinite sample, or the mask has another size or leaves no pixel. A mask takes pixels out of the
// means and of the metering of hdr_flip_map(); the filters of ssim and flip still see them.
Result<PictureErrors> scene_errors(const ImageF& test, const ImageF& reference,
                                   const Mask* mask = nullptr);

// Display-referred pictures in sRGB with 3 or 4 channels each; alpha is left out. Fails in the same
// way.
Result<PictureErrors> display_errors(const Image8& test, const Image8& reference,
                                     const Mask* mask = nullptr);

// Fails (ErrorKind::input) when a sample is NaN or infinite; says how many pixels have one and
// where the first is. `name` stands for the picture.
Result<void> check_finite(const ImageF& image, const std::string& name);

// The checks of scene_errors() on the two pictures.
Result<void> check_comparable(const ImageF& test, const ImageF& reference);

}  // namespace lueur
