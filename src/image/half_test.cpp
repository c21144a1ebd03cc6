// SPDX-License-Identifier: MIT
#include "image/half.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace lueur {
namespace {

TEST(Half, KnownBitPatterns) {
  EXPECT_EQ(half_from_float(0.0f), 0x0000);
  EXPECT_EQ(half_from_float(-0.0f), 0x8000);
  EXPECT_EQ(half_from_float(1.0f), 0x3c00);
  EXPECT_EQ(half_from_float(-2.0f), 0xc000);
  EXPECT_EQ(half_from_float(kLargestHalf), 0x7bff);
  EXPECT_EQ(half_from_float(65520.0f), 0x7c00);
  EXPECT_EQ(half_from_float(std::ldexp(1.0f, -24)), 0x0001);
  EXPECT_EQ(half_from_float(std::ldexp(1.0f, -26)), 0x0000);
}

TEST(Half, RoundsToNearestEven) {
  EXPECT_EQ(half_from_float(1.0f + std::ldexp(1.0f, -11)), 0x3c00);
  EXPECT_EQ(half_from_float(1.0f + 3.0f * std::ldexp(1.0f, -11)), 0x3c02);
}

TEST(Half, EveryNumberSurvivesTheRoundTrip) {
  for (uint32_t bits = 0; bits <= 0xffff; ++bits) {
    const float value = float_from_half(static_cast<uint16_t>(bits));
    if (std::isnan(value))
      EXPECT_TRUE(std::isnan(float_from_half(half_from_float(value)))) << bits;
    else
      EXPECT_EQ(half_from_float(value), bits);
  }
}

TEST(Half, ManyAtOnce) {
  const std::array<uint16_t, 3> halves = {0x3c00, 0xc000, 0x7c00};
  const std::vector<float> expected = {1.0f, -2.0f, std::numeric_limits<float>::infinity()};
  EXPECT_EQ(floats_from_halves(halves), expected);
}

}  // namespace
}  // namespace lueur
