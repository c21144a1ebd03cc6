// SPDX-License-Identifier: MIT
#include "image/flip_hdr.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lueur {
namespace {

// Light over several stops, as in a room with a lamp.
ImageF room(uint32_t seed) {
  ImageF image(36, 24, 3);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> stops(-3.0f, 4.0f);
  for (float& sample : image.samples) sample = std::exp2(stops(random));
  return image;
}

ImageF with_noise(ImageF image, float strength) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-strength, strength);
  for (float& sample : image.samples) sample *= std::exp2(noise(random));
  return image;
}

ImageF grey_row(std::vector<float> values) {
  ImageF image(static_cast<uint32_t>(values.size()), 1, 1);
  image.samples = std::move(values);
  return image;
}

TEST(HdrFlip, ToneCurve) {
  // Narkowicz's fit at 0.6 x.
  for (const double x : {0.01, 0.18, 1.0, 3.0}) {
    const double y = 0.6 * x;
    const double expected = y * (2.51 * y + 0.03) / (y * (2.43 * y + 0.59) + 0.14);
    EXPECT_NEAR(flip_exposed(grey_row({static_cast<float>(x)}), 0.0f).samples[0],
                std::min(expected, 1.0), 1e-6);
  }
  const ImageF stops = flip_exposed(grey_row({0.5f, 2.0f}), 2.0f);
  EXPECT_EQ(stops.samples[0], flip_exposed(grey_row({2.0f}), 0.0f).samples[0]);
  EXPECT_EQ(flip_exposed(grey_row({-1.0f, 3e38f}), 0.0f).samples, (std::vector<float>{0.0f, 1.0f}));
}

TEST(HdrFlip, ExposuresGoFromTheBrightestToTheMedian) {
  const FlipExposures e = flip_exposures(grey_row({0.5f, 64.0f, 0.25f, 0.75f, 0.5f}));
  EXPECT_NEAR(flip_exposed(grey_row({64.0f}), e.start_ev).samples[0], 0.85f, 1e-5f);
  EXPECT_NEAR(flip_exposed(grey_row({0.5f}), e.stop_ev).samples[0], 0.85f, 1e-5f);
  EXPECT_NEAR(e.stop_ev - e.start_ev, 7.0f, 1e-5f);
  // Seven stops up to rounding, which may make them an eighth.
  EXPECT_GE(e.count, 7u);
  EXPECT_LE(e.count, 8u);
  EXPECT_EQ(flip_exposures(grey_row({1.0f, 1.2f, 1.0f})).count, 2u);
  // Of an even number of pixels, the mean of the two in the middle.
  const FlipExposures even = flip_exposures(grey_row({4.0f, 1.0f, 3.0f, 64.0f}));
  EXPECT_NEAR(flip_exposed(grey_row({3.5f}), even.stop_ev).samples[0], 0.85f, 1e-5f);
}

TEST(HdrFlip, ExposuresOfDarkPictures) {
  const FlipExposures black = flip_exposures(grey_row({0.0f, 0.0f}));
  EXPECT_EQ(black.count, 1u);
  EXPECT_EQ(black.start_ev, 0.0f);
  const FlipExposures mostly = flip_exposures(grey_row({0.0f, 0.0f, 0.0f, 2.0f, 16.0f}));
  const FlipExposures lit = flip_exposures(grey_row({2.0f, 16.0f}));
  EXPECT_EQ(mostly.stop_ev, lit.stop_ev);
  EXPECT_EQ(mostly.start_ev, lit.start_ev);
}

TEST(HdrFlip, MaskedPixelsAreNotMetered) {
  const Mask mask{3, 1, {1, 0, 1}};
  const FlipExposures masked = flip_exposures(grey_row({1.0f, 1e6f, 2.0f}), &mask);
  const FlipExposures without = flip_exposures(grey_row({1.0f, 2.0f}));
  EXPECT_EQ(masked.start_ev, without.start_ev);
  EXPECT_EQ(masked.stop_ev, without.stop_ev);
}

TEST(HdrFlip, IsTheLargestOverTheExposures) {
  const ImageF reference = room(1);
  const ImageF test = with_noise(reference, 0.5f);
  const FlipExposures exposures{-2.0f, 2.0f, 3};
  ImageF expected(reference.width, reference.height, 1);
  for (const float ev : {-2.0f, 0.0f, 2.0f}) {
    const ImageF map = flip_map(flip_exposed(test, ev), flip_exposed(reference, ev));
    for (size_t i = 0; i < map.samples.size(); ++i)
      expected.samples[i] = std::max(expected.samples[i], map.samples[i]);
  }
  EXPECT_EQ(hdr_flip_map(test, reference, exposures).samples, expected.samples);
  const FlipExposures one{0.5f, 0.5f, 1};
  EXPECT_EQ(hdr_flip_map(test, reference, one).samples,
            flip_map(flip_exposed(test, 0.5f), flip_exposed(reference, 0.5f)).samples);
}

TEST(HdrFlip, EqualPicturesDoNotDiffer) {
  const ImageF image = room(2);
  for (const float value : hdr_flip_map(image, image, flip_exposures(image)).samples)
    EXPECT_EQ(value, 0.0f);
}

TEST(HdrFlip, GrowsWithNoise) {
  const ImageF reference = room(3);
  const FlipExposures exposures = flip_exposures(reference);
  double last = 0.0;
  for (const float strength : {0.05f, 0.2f, 0.8f, 3.0f}) {
    const double error =
        mean(hdr_flip_map(with_noise(reference, strength), reference, exposures), nullptr);
    EXPECT_GT(error, last) << strength;
    last = error;
  }
  EXPECT_LT(last, 1.0);
}

// The exposures follow the picture, so its unit does not matter. Bound: of single precision.
TEST(HdrFlip, HasNoUnit) {
  ImageF reference = room(4);
  ImageF test = with_noise(reference, 0.3f);
  const double before = mean(hdr_flip_map(test, reference, flip_exposures(reference)), nullptr);
  for (ImageF* image : {&reference, &test})
    for (float& sample : image->samples) sample *= 4096.0f;
  EXPECT_NEAR(mean(hdr_flip_map(test, reference, flip_exposures(reference)), nullptr), before,
              1e-5);
}

}  // namespace
}  // namespace lueur
