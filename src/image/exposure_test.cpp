// SPDX-License-Identifier: MIT
#include "image/exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lueur {
namespace {

ImageF grey(std::vector<float> values) {
  ImageF image(static_cast<uint32_t>(values.size()), 1, 1);
  image.samples = std::move(values);
  return image;
}

constexpr float kRoundingEv = 1e-6f;  // 0.18 has no exact float

TEST(Exposure, UniformPictureBecomesMiddleGrey) {
  for (const float y : {1e-6f, 0.18f, 1.0f, 5000.0f})
    EXPECT_NEAR(auto_exposure_ev(grey({y, y, y})), std::log2(0.18f / y), 2 * kRoundingEv) << y;
}

TEST(Exposure, AveragesLogarithms) {
  EXPECT_FLOAT_EQ(auto_exposure_ev(grey({1.0f, 4.0f})), std::log2(0.18f / 2.0f));
}

TEST(Exposure, ColourCountsByItsLuminance) {
  ImageF image(1, 1, 3);
  image.samples = {0.0f, 1.0f, 0.0f};
  EXPECT_FLOAT_EQ(auto_exposure_ev(image), std::log2(0.18f / 0.7152f));
}

TEST(Exposure, DarkAndBrokenPixelsDoNotCount) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_NEAR(auto_exposure_ev(grey({0.0f, -1.0f, nan, infinity, 0.18f})), 0.0f, kRoundingEv);
  EXPECT_EQ(auto_exposure_ev(grey({0.0f, nan, -3.0f})), 0.0f);
  EXPECT_EQ(auto_exposure_ev(ImageF(0, 0, 3)), 0.0f);
}

TEST(Exposure, HighlightsAreHeld) {
  // 2 % of the pixels are lit 10^6 times as much as the rest: the 99th percentile is among them.
  std::vector<float> values(100, 1e-3f);
  values[10] = values[90] = 1e3f;
  EXPECT_FLOAT_EQ(auto_exposure_ev(grey(values)), std::log2(4.0f / 1e3f));

  // A single one in 200 is above the percentile and may burn out.
  std::vector<float> one(200, 0.18f);
  one[100] = 1e6f;
  const float log2_average = (199.0f * std::log2(0.18f) + std::log2(1e6f)) / 200.0f;
  EXPECT_NEAR(auto_exposure_ev(grey(one)), std::log2(0.18f) - log2_average, 1e-5f);
}

}  // namespace
}  // namespace lueur
