// SPDX-License-Identifier: MIT
#include "image/picture_error.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "image/exposure.h"
#include "image/flip.h"
#include "image/flip_hdr.h"
#include "image/sample_error.h"
#include "image/ssim.h"
#include "image/tone_map.h"

namespace lueur {
namespace {

std::string size_text(uint32_t width, uint32_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

template <class Image>
Result<void> check_sizes(const Image& test, const Image& reference) {
  if (test.width != reference.width || test.height != reference.height)
    return Error{ErrorKind::input,
                 "the pictures differ in size: the test has " + size_text(test.width, test.height) +
                     " pixels, the reference " + size_text(reference.width, reference.height) +
                     "; render both in one size"};
  if (test.samples.empty()) return Error{ErrorKind::input, "the pictures have no pixels"};
  return {};
}

template <class Image>
Result<void> check_mask(const Mask* mask, const Image& picture) {
  if (mask == nullptr) return {};
  if (mask->width != picture.width || mask->height != picture.height)
    return Error{ErrorKind::input, "the mask has " + size_text(mask->width, mask->height) +
                                       " pixels, the pictures " +
                                       size_text(picture.width, picture.height)};
  if (mask->pixel_count() == 0)
    return Error{ErrorKind::input, "the mask leaves no pixel to compare; choose another layer"};
  return {};
}

// The colours, sRGB-encoded in [0, 1].
ImageF encoded(const Image8& image) {
  ImageF result(image.width, image.height, 3);
  const size_t pixels = size_t{image.width} * image.height;
  for (size_t i = 0; i < pixels; ++i)
    for (size_t c = 0; c < 3; ++c)
      result.samples[3 * i + c] =
          static_cast<float>(image.samples[i * image.channels + c]) / 255.0f;
  return result;
}

ImageF decoded(const ImageF& picture) {
  std::array<float, 256> linear{};
  for (size_t code = 0; code < linear.size(); ++code)
    linear[code] = linear_from_srgb(static_cast<float>(code) / 255.0f);
  ImageF result = picture;
  for (float& sample : result.samples)
    sample = linear[static_cast<size_t>(std::lround(sample * 255.0f))];
  return result;
}

ImageF luma(const ImageF& picture) {
  ImageF result(picture.width, picture.height, 1);
  for (size_t i = 0; i < result.samples.size(); ++i) result.samples[i] = luminance_at(picture, i);
  return result;
}

void set_sample_errors(PictureErrors& errors, const ImageF& test, const ImageF& reference,
                       const Mask* mask) {
  const SampleErrors samples = sample_errors(test, reference, mask);
  errors.rmse = samples.rmse;
  errors.rel_mse = samples.rel_mse;
  errors.bias = samples.bias;
  errors.rmse_scaled = samples.rmse_scaled;
  errors.scale = samples.scale;
  errors.relative_map = relative_error_map(test, reference, mask);
}

// `test` and `reference` are sRGB-encoded.
void set_ssim(PictureErrors& errors, const ImageF& test, const ImageF& reference,
              const Mask* mask) {
  errors.ssim_map = ssim_map(luma(test), luma(reference));
  errors.ssim = mean(errors.ssim_map, mask);
}

}  // namespace

Result<void> check_finite(const ImageF& image, const std::string& name) {
  size_t broken = 0;
  size_t first = 0;
  const size_t pixels = size_t{image.width} * image.height;
  for (size_t i = 0; i < pixels; ++i) {
    const float* pixel = &image.samples[i * image.channels];
    if (std::all_of(pixel, pixel + image.channels, [](float v) { return std::isfinite(v); }))
      continue;
    if (broken++ == 0) first = i;
  }
  if (broken == 0) return {};
  return Error{ErrorKind::input, name + ": " + std::to_string(broken) + " of " +
                                     std::to_string(pixels) +
                                     " pixels are NaN or infinite, the first at (" +
                                     std::to_string(first % image.width) + ", " +
                                     std::to_string(first / image.width) +
                                     "); find their cause before measuring an error"};
}

Result<void> check_comparable(const ImageF& test, const ImageF& reference) {
  LUEUR_TRY_VOID(check_sizes(test, reference));
  if (test.channels != reference.channels)
    return Error{ErrorKind::input, "the pictures differ in channels: the test has " +
                                       std::to_string(test.channels) + ", the reference " +
                                       std::to_string(reference.channels)};
  if (test.channels != 1 && test.channels != 3 && test.channels != 4)
    return Error{ErrorKind::input,
                 "pictures of " + std::to_string(test.channels) +
                     " channels cannot be compared; choose a layer of 1, 3 or 4 channels"};
  LUEUR_TRY_VOID(check_finite(test, "the test picture"));
  return check_finite(reference, "the reference");
}

Result<PictureErrors> scene_errors(const ImageF& test, const ImageF& reference, const Mask* mask) {
  LUEUR_TRY_VOID(check_comparable(test, reference));
  LUEUR_TRY_VOID(check_mask(mask, test));
  PictureErrors errors;
  set_sample_errors(errors, test, reference, mask);

  // Show both at the exposure that suits the reference.
  const float exposure_ev = auto_exposure_ev(reference);
  const auto shown = [&](const ImageF& image) {
    return encoded(to_display(image, exposure_ev, ToneMap::khronos_neutral));
  };
  const ImageF shown_test = shown(test);
  const ImageF shown_reference = shown(reference);
  errors.psnr = psnr_db(sample_errors(shown_test, shown_reference, mask).rmse, 1.0);
  set_ssim(errors, shown_test, shown_reference, mask);

  errors.flip_map = hdr_flip_map(test, reference, flip_exposures(reference, mask));
  errors.flip = mean(errors.flip_map, mask);
  return errors;
}

Result<PictureErrors> display_errors(const Image8& test, const Image8& reference,
                                     const Mask* mask) {
  LUEUR_TRY_VOID(check_sizes(test, reference));
  LUEUR_TRY_VOID(check_mask(mask, test));
  const ImageF shown_test = encoded(test);
  const ImageF shown_reference = encoded(reference);
  PictureErrors errors;
  set_sample_errors(errors, shown_test, shown_reference, mask);
  errors.psnr = psnr_db(errors.rmse, 1.0);
  set_ssim(errors, shown_test, shown_reference, mask);
  errors.flip_map = flip_map(decoded(shown_test), decoded(shown_reference));
  errors.flip = mean(errors.flip_map, mask);
  return errors;
}

}  // namespace lueur
