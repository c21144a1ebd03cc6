// SPDX-License-Identifier: MIT
#include "image/picture_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "image/exposure.h"
#include "image/flip.h"
#include "image/flip_hdr.h"
#include "image/tone_map.h"

namespace lueur {
namespace {

ImageF light(uint32_t seed, uint32_t channels = 3) {
  ImageF image(24, 16, channels);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> stops(-2.0f, 2.0f);
  for (float& sample : image.samples) sample = std::exp2(stops(random));
  return image;
}

Image8 grey8(uint8_t code, uint32_t channels = 3) {
  Image8 image{24, 16, channels, {}};
  image.samples.assign(size_t{24} * 16 * channels, code);
  return image;
}

void expect_refused(const Result<PictureErrors>& result, const std::string& part) {
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::input);
  EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
}

TEST(PictureError, EqualPicturesHaveNone) {
  const auto scene = scene_errors(light(1), light(1));
  const auto display = display_errors(grey8(100), grey8(100, 4));  // alpha is left out
  for (const auto* errors : {&scene, &display}) {
    ASSERT_TRUE(errors->ok()) << errors->error().message;
    for (const ErrorMetric& metric : kErrorMetrics)
      if (metric.is_error) {
        EXPECT_EQ((**errors).*metric.value, 0.0) << metric.name;
      }
    EXPECT_EQ((*errors)->scale, 1.0);
    EXPECT_EQ((*errors)->psnr, std::numeric_limits<double>::infinity());
    EXPECT_NEAR((*errors)->ssim, 1.0, 1e-5);
  }
}

TEST(PictureError, MetricsHaveNames) {
  std::set<std::string_view> names;
  for (const ErrorMetric& metric : kErrorMetrics) names.insert(metric.name);
  EXPECT_EQ(names.size(), kErrorMetrics.size());
}

TEST(PictureError, DisplayReferredSamplesAreCodeValues) {
  const auto errors = display_errors(grey8(151), grey8(100));
  ASSERT_TRUE(errors.ok()) << errors.error().message;
  EXPECT_NEAR(errors->rmse, 51.0 / 255.0, 1e-7);
  EXPECT_NEAR(errors->psnr, 20.0 * std::log10(255.0 / 51.0), 1e-5);
  EXPECT_NEAR(errors->bias, 0.51, 1e-6);
  EXPECT_NEAR(errors->scale, 100.0 / 151.0, 1e-6);
  EXPECT_NEAR(errors->rmse_scaled, 0.0, 1e-7);
  const double t = 151.0 / 255.0, r = 100.0 / 255.0;
  EXPECT_NEAR(errors->ssim, (2 * t * r + 1e-4) / (t * t + r * r + 1e-4), 1e-3);
}

// The file's path through linear light is that of FLIP's definition: sRGB is decoded.
TEST(PictureError, FlipDecodesSrgb) {
  ImageF test(24, 16, 1), reference(24, 16, 1);
  for (float& sample : test.samples) sample = linear_from_srgb(151.0f / 255.0f);
  for (float& sample : reference.samples) sample = linear_from_srgb(100.0f / 255.0f);
  const auto errors = display_errors(grey8(151), grey8(100));
  ASSERT_TRUE(errors.ok());
  EXPECT_EQ(errors->flip, mean(flip_map(test, reference), nullptr));
  EXPECT_GT(errors->flip, 0.1);
}

TEST(PictureError, ScenesAreShownAtTheReferencesExposure) {
  const ImageF reference = light(2);
  ImageF test = reference;
  for (float& sample : test.samples) sample *= 1.5f;
  const auto errors = scene_errors(test, reference);
  ASSERT_TRUE(errors.ok()) << errors.error().message;
  EXPECT_NEAR(errors->bias, 0.5, 1e-6);
  EXPECT_NEAR(errors->scale, 1.0 / 1.5, 1e-6);
  EXPECT_NEAR(errors->rmse_scaled, 0.0, 1e-6);
  const float exposure_ev = auto_exposure_ev(reference);
  const auto display = display_errors(to_display(test, exposure_ev, ToneMap::khronos_neutral),
                                      to_display(reference, exposure_ev, ToneMap::khronos_neutral));
  ASSERT_TRUE(display.ok());
  EXPECT_EQ(errors->psnr, display->psnr);
  EXPECT_EQ(errors->ssim, display->ssim);
  EXPECT_EQ(errors->flip_map.samples,
            hdr_flip_map(test, reference, flip_exposures(reference)).samples);
  EXPECT_EQ(errors->flip, mean(errors->flip_map, nullptr));
}

TEST(PictureError, MaskedPixelsDoNotCount) {
  const ImageF reference = light(3);
  ImageF test = reference;
  Mask mask{24, 16, std::vector<uint8_t>(size_t{24} * 16, 1)};
  // The right half is wrong; the filters reach 10 pixels into the left one.
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 24; ++x) {
      if (x >= 12)
        for (uint32_t c = 0; c < 3; ++c) test.at(x, y, c) = 50.0f;
      mask.counts[size_t{y} * 24 + x] = x < 2 ? 1 : 0;
    }
  const auto errors = scene_errors(test, reference, &mask);
  ASSERT_TRUE(errors.ok()) << errors.error().message;
  EXPECT_EQ(errors->rmse, 0.0);
  EXPECT_EQ(errors->bias, 0.0);
  EXPECT_EQ(errors->flip, 0.0);
  EXPECT_NEAR(errors->ssim, 1.0, 1e-5);
  EXPECT_EQ(errors->psnr, std::numeric_limits<double>::infinity());
  EXPECT_GT(scene_errors(test, reference)->flip, 0.1);
}

TEST(PictureError, MaskedPixelsAreNotMetered) {
  ImageF reference = light(7);
  for (uint32_t c = 0; c < 3; ++c) reference.at(23, 15, c) = 4000.0f;  // a lamp, which is masked
  ImageF test = reference;
  for (float& sample : test.samples) sample *= 1.2f;
  Mask mask{24, 16, std::vector<uint8_t>(384, 1)};
  mask.counts.back() = 0;
  const auto errors = scene_errors(test, reference, &mask);
  ASSERT_TRUE(errors.ok()) << errors.error().message;
  EXPECT_EQ(errors->flip_map.samples,
            hdr_flip_map(test, reference, flip_exposures(reference, &mask)).samples);
  EXPECT_NE(errors->flip_map.samples,
            hdr_flip_map(test, reference, flip_exposures(reference)).samples);
}

TEST(PictureError, BrokenSamplesAreCountedAndNamed) {
  const ImageF good = light(4);
  ImageF bad = good;
  bad.at(5, 3, 1) = std::numeric_limits<float>::quiet_NaN();
  bad.at(5, 3, 2) = std::numeric_limits<float>::infinity();
  bad.at(2, 9, 0) = -std::numeric_limits<float>::infinity();
  expect_refused(scene_errors(bad, good), "the test picture: 2 of 384 pixels");
  expect_refused(scene_errors(bad, good), "(5, 3)");
  expect_refused(scene_errors(good, bad), "the reference: 2 of 384 pixels");
  // Beside the mask, too: the filters would carry it in.
  Mask mask{24, 16, std::vector<uint8_t>(384, 0)};
  mask.counts[0] = 1;
  expect_refused(scene_errors(bad, good, &mask), "(5, 3)");
}

TEST(PictureError, PicturesThatDoNotMatch) {
  const ImageF image = light(5);
  expect_refused(scene_errors(ImageF(24, 15, 3), image), "24x15");
  expect_refused(scene_errors(light(5, 1), image), "channels");
  expect_refused(scene_errors(light(5, 2), light(5, 2)), "2 channels");
  expect_refused(scene_errors(ImageF(0, 0, 3), ImageF(0, 0, 3)), "no pixels");
  const Mask narrow{2, 1, {1, 1}};
  expect_refused(scene_errors(image, image, &narrow), "2x1");
  const Mask none{24, 16, std::vector<uint8_t>(384, 0)};
  expect_refused(scene_errors(image, image, &none), "no pixel");
  expect_refused(display_errors(grey8(1), Image8{1, 1, 3, {0, 0, 0}}), "1x1");
}

TEST(PictureError, ExtremeLightStaysFinite) {
  ImageF bright = light(6), dark = light(6);
  bright.at(0, 0, 0) = std::numeric_limits<float>::max();
  dark.at(0, 0, 0) = std::numeric_limits<float>::denorm_min();
  for (const auto& [test, reference] : {std::pair(&bright, &dark), {&dark, &bright}}) {
    const auto errors = scene_errors(*test, *reference);
    ASSERT_TRUE(errors.ok());
    for (const ErrorMetric& metric : kErrorMetrics)
      EXPECT_TRUE(std::isfinite((*errors).*metric.value)) << metric.name;
    for (const float value : errors->flip_map.samples) EXPECT_TRUE(value >= 0.0f && value <= 1.0f);
  }
}

}  // namespace
}  // namespace lueur
