// SPDX-License-Identifier: MIT
#include "image/sample_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lueur {
namespace {

// Of sums of a few rounded terms.
constexpr double kRounding = 1e-14;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

ImageF uniform(float value, uint32_t channels = 3) {
  ImageF image(4, 3, channels);
  for (float& sample : image.samples) sample = value;
  return image;
}

ImageF noise(uint32_t seed, uint32_t channels = 3) {
  ImageF image(31, 17, channels);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform_01;
  for (float& sample : image.samples) sample = uniform_01(random);
  return image;
}

ImageF scaled(ImageF image, float factor) {
  for (float& sample : image.samples) sample *= factor;
  return image;
}

TEST(SampleError, EqualPicturesHaveNone) {
  const ImageF image = noise(1);
  const SampleErrors errors = sample_errors(image, image);
  EXPECT_EQ(errors.rmse, 0.0);
  EXPECT_EQ(errors.rel_mse, 0.0);
  EXPECT_EQ(errors.bias, 0.0);
  EXPECT_EQ(errors.scale, 1.0);
  EXPECT_EQ(errors.rmse_scaled, 0.0);
}

TEST(SampleError, ConstantOffset) {
  const SampleErrors errors = sample_errors(uniform(2.5f), uniform(2.0f));
  EXPECT_DOUBLE_EQ(errors.rmse, 0.5);
  EXPECT_DOUBLE_EQ(errors.rel_mse, 0.25 / (4.0 + 0.01 * 4.0));
  EXPECT_DOUBLE_EQ(errors.bias, 0.25);
  EXPECT_DOUBLE_EQ(errors.scale, 0.8);
  EXPECT_NEAR(errors.rmse_scaled, 0.0, kRounding);
}

TEST(SampleError, ScaledPictureIsOnlyTooBright) {
  const ImageF image = noise(2);
  const SampleErrors errors = sample_errors(scaled(image, 4.0f), image);
  EXPECT_DOUBLE_EQ(errors.bias, 3.0);
  EXPECT_DOUBLE_EQ(errors.scale, 0.25);
  EXPECT_NEAR(errors.rmse_scaled, 0.0, kRounding);
  EXPECT_GT(errors.rmse, 1.0);
}

// t = r + e with e orthogonal to r: the best scale is r.r / (r.r + e.e), which leaves
// |r| |e| / |t|.
TEST(SampleError, BestScaleLeavesTheShape) {
  ImageF r(4, 1, 1), t(4, 1, 1);
  r.samples = {3.0f, 3.0f, 3.0f, 3.0f};
  t.samples = {4.0f, 2.0f, 4.0f, 2.0f};
  const SampleErrors errors = sample_errors(t, r);
  EXPECT_DOUBLE_EQ(errors.scale, 0.9);
  EXPECT_DOUBLE_EQ(errors.rmse, 1.0);
  EXPECT_DOUBLE_EQ(errors.bias, 0.0);
  EXPECT_DOUBLE_EQ(errors.rmse_scaled, 3.0 / std::sqrt(10.0));
}

TEST(SampleError, WhichOneIsTheReferenceMatters) {
  const SampleErrors up = sample_errors(uniform(3.0f), uniform(1.0f));
  const SampleErrors down = sample_errors(uniform(1.0f), uniform(3.0f));
  EXPECT_DOUBLE_EQ(up.rmse, down.rmse);
  EXPECT_DOUBLE_EQ(up.bias, 2.0);
  EXPECT_DOUBLE_EQ(down.bias, -2.0 / 3.0);
  EXPECT_NEAR(up.rel_mse, 4.0 / 1.01, kRounding);
  EXPECT_NEAR(down.rel_mse, 4.0 / 9.09, kRounding);
}

TEST(SampleError, RelativeErrorsHaveNoUnit) {
  const SampleErrors lux = sample_errors(noise(3), noise(4));
  const SampleErrors kilolux = sample_errors(scaled(noise(3), 1024.0f), scaled(noise(4), 1024.0f));
  EXPECT_DOUBLE_EQ(kilolux.rel_mse, lux.rel_mse);
  EXPECT_DOUBLE_EQ(kilolux.bias, lux.bias);
  EXPECT_DOUBLE_EQ(kilolux.rmse, 1024.0 * lux.rmse);
}

TEST(SampleError, BlackPixelsWeighNoMoreThanAHundredTimes) {
  ImageF r(2, 1, 1), t(2, 1, 1);
  r.samples = {0.0f, 2.0f};  // mean square 2, e = 0.02
  t.samples = {0.1f, 2.0f};
  EXPECT_NEAR(sample_errors(t, r).rel_mse, 0.5 * 0.01 / 0.02, 1e-8);
}

TEST(SampleError, BlackReference) {
  const SampleErrors same = sample_errors(uniform(0.0f), uniform(0.0f));
  EXPECT_EQ(same.rel_mse, 0.0);
  EXPECT_EQ(same.bias, 0.0);
  EXPECT_EQ(same.scale, 1.0);
  const SampleErrors lit = sample_errors(uniform(1.0f), uniform(0.0f));
  EXPECT_EQ(lit.rel_mse, kInfinity);
  EXPECT_EQ(lit.bias, kInfinity);
  EXPECT_EQ(lit.scale, 0.0);
  EXPECT_EQ(lit.rmse_scaled, 0.0);
}

TEST(SampleError, MaskAndCoverageAreLeftOut) {
  ImageF r = uniform(1.0f, 4);
  ImageF t = uniform(1.5f, 4);
  for (uint32_t x = 0; x < 4; ++x) {
    t.at(x, 0, 3) = 9.0f;                                      // coverage
    for (uint32_t c = 0; c < 3; ++c) t.at(x, 1, c) = 1000.0f;  // the masked row
  }
  Mask mask{4, 3, std::vector<uint8_t>(12, 1)};
  for (size_t i = 4; i < 8; ++i) mask.counts[i] = 0;
  EXPECT_EQ(mask.pixel_count(), 8u);
  const SampleErrors errors = sample_errors(t, r, &mask);
  EXPECT_DOUBLE_EQ(errors.rmse, 0.5);
  EXPECT_DOUBLE_EQ(errors.bias, 0.5);
  EXPECT_NEAR(errors.rel_mse, 0.25 / 1.01, kRounding);
  EXPECT_DOUBLE_EQ(errors.scale, 1.0 / 1.5);
  const ImageF map = relative_error_map(t, r, &mask);
  EXPECT_EQ(map.at(2, 1, 0), 0.0f);
  EXPECT_FLOAT_EQ(map.at(2, 2, 0), 0.5f / std::sqrt(1.01f));
}

TEST(SampleError, MapHoldsTheRelativeError) {
  const ImageF t = noise(5), r = noise(6);
  const ImageF map = relative_error_map(t, r);
  double squares = 0.0;
  for (const float value : map.samples)
    squares += static_cast<double>(value) * static_cast<double>(value);
  EXPECT_NEAR(squares / (31 * 17), sample_errors(t, r).rel_mse, 1e-5);
}

// In single precision a sum of 2^22 ones with 1e-4 on top is off by more than that in the mean.
TEST(SampleError, LargePicturesAreSummedPrecisely) {
  ImageF r(2048, 2048, 1), t(2048, 2048, 1);
  for (float& sample : r.samples) sample = 1.0f;
  for (float& sample : t.samples) sample = 1.0f + 0x1p-13f;
  const SampleErrors errors = sample_errors(t, r);
  EXPECT_DOUBLE_EQ(errors.bias, 0x1p-13);
  EXPECT_DOUBLE_EQ(errors.rmse, 0x1p-13);
}

TEST(SampleError, MaskOfALayer) {
  ImageF normal(2, 2, 3);
  normal.at(1, 0, 2) = -1.0f;
  normal.at(0, 1, 0) = 1.0f;
  EXPECT_EQ(mask_of(normal).counts, (std::vector<uint8_t>{0, 1, 1, 0}));
  ImageF plane(2, 2, 1);
  plane.samples = {1.0f, 2.0f, 4.0f, 8.0f};
  const Mask mask = mask_of(normal);
  EXPECT_DOUBLE_EQ(mean(plane, &mask), 3.0);
  EXPECT_DOUBLE_EQ(mean(plane, nullptr), 3.75);
}

TEST(Psnr, OfKnownErrors) {
  EXPECT_DOUBLE_EQ(psnr_db(0.1, 1.0), 20.0);
  EXPECT_DOUBLE_EQ(psnr_db(1.0, 255.0), 20.0 * std::log10(255.0));
  EXPECT_EQ(psnr_db(0.0, 1.0), kInfinity);
}

}  // namespace
}  // namespace lueur
