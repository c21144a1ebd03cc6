// SPDX-License-Identifier: MIT
#include "image/ssim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lueur {
namespace {

constexpr double kC1 = 1e-4;
constexpr double kC2 = 9e-4;
// The variances are differences of single-precision means of up to 1: a few 2^-24, against C2.
constexpr double kBound = 5e-4;

ImageF noise(uint32_t width, uint32_t height, uint32_t seed) {
  ImageF image(width, height, 1);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform;
  for (float& sample : image.samples) sample = uniform(random);
  return image;
}

ImageF uniform(float value) {
  ImageF image(20, 15, 1);
  for (float& sample : image.samples) sample = value;
  return image;
}

// The definition at one pixel, as a double sum in double precision.
double direct(const ImageF& t, const ImageF& r, int x, int y) {
  double weights = 0, mt = 0, mr = 0, tt = 0, rr = 0, tr = 0;
  for (int j = -5; j <= 5; ++j)
    for (int i = -5; i <= 5; ++i) {
      const auto px = static_cast<uint32_t>(std::clamp(x + i, 0, static_cast<int>(t.width) - 1));
      const auto py = static_cast<uint32_t>(std::clamp(y + j, 0, static_cast<int>(t.height) - 1));
      const double w = std::exp(-(i * i + j * j) / (2 * 1.5 * 1.5));
      const double a = t.at(px, py, 0), b = r.at(px, py, 0);
      weights += w;
      mt += w * a, mr += w * b, tt += w * a * a, rr += w * b * b, tr += w * a * b;
    }
  mt /= weights, mr /= weights, tt /= weights, rr /= weights, tr /= weights;
  return (2 * mt * mr + kC1) * (2 * (tr - mt * mr) + kC2) /
         ((mt * mt + mr * mr + kC1) * (tt - mt * mt + rr - mr * mr + kC2));
}

TEST(Ssim, EqualPicturesAreOne) {
  const ImageF image = noise(20, 15, 1);
  for (const float value : ssim_map(image, image).samples) EXPECT_NEAR(value, 1.0, kBound);
}

TEST(Ssim, UniformPicturesDifferInLuminanceOnly) {
  for (const auto& [a, b] : {std::pair(0.2, 0.6), {0.0, 1.0}, {0.5, 0.51}}) {
    const double expected = (2 * a * b + kC1) / (a * a + b * b + kC1);
    const ImageF map = ssim_map(uniform(static_cast<float>(a)), uniform(static_cast<float>(b)));
    for (const float value : map.samples) EXPECT_NEAR(value, expected, kBound);
  }
}

TEST(Ssim, IsItsDefinition) {
  // Odd sizes, and one smaller than the window.
  for (const auto& [width, height] : {std::pair(23u, 17u), {5u, 3u}}) {
    const ImageF t = noise(width, height, 2);
    ImageF r = noise(width, height, 3);
    for (size_t i = 0; i < r.samples.size(); ++i)
      r.samples[i] = 0.3f * r.samples[i] + 0.5f * t.samples[i];
    const ImageF map = ssim_map(t, r);
    for (uint32_t y = 0; y < height; ++y)
      for (uint32_t x = 0; x < width; ++x)
        EXPECT_NEAR(map.at(x, y, 0), direct(t, r, static_cast<int>(x), static_cast<int>(y)), kBound)
            << x << ", " << y;
  }
}

TEST(Ssim, IsSymmetric) {
  const ImageF a = noise(19, 13, 4), b = noise(19, 13, 5);
  const ImageF ab = ssim_map(a, b), ba = ssim_map(b, a);
  for (size_t i = 0; i < ab.samples.size(); ++i) EXPECT_NEAR(ab.samples[i], ba.samples[i], 1e-6);
}

// Around one mean, a pattern turned upside down has minus the covariance of the pattern itself.
TEST(Ssim, InvertedPatternIsNegative) {
  const ImageF image = noise(30, 30, 6);
  ImageF inverted = image;
  for (float& sample : inverted.samples) sample = 1.0f - sample;
  const ImageF map = ssim_map(inverted, image);
  EXPECT_LT(map.at(15, 15, 0), -0.8f);
  EXPECT_GT(map.at(15, 15, 0), -1.0f);
}

}  // namespace
}  // namespace lueur
