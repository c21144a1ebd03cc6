// SPDX-License-Identifier: MIT
#include "image/color_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "image/exposure.h"

namespace lueur {
namespace {

using Code = std::array<uint8_t, 3>;

TEST(ColorMap, EndsAndMiddleOfMagma) {
  // Entries 0, 128 and 255 of the published table, times 255.
  EXPECT_EQ(magma(0.0f), (Code{0, 0, 4}));
  EXPECT_EQ(magma(128.0f / 255.0f), (Code{183, 55, 121}));
  EXPECT_EQ(magma(1.0f), (Code{252, 253, 191}));
}

TEST(ColorMap, EntriesBetweenTheStoredOnes) {
  // Entries 60 and 180, in the middle between two that are stored.
  const auto near = [](Code a, Code b) {
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1) << c;
  };
  near(magma(60.0f / 255.0f), {74, 16, 121});
  near(magma(180.0f / 255.0f), {247, 114, 92});
}

TEST(ColorMap, GetsEverLighter) {
  float last = -1.0f;
  for (int i = 0; i <= 64; ++i) {
    const Code code = magma(static_cast<float>(i) / 64.0f);
    const float light = luminance(code[0], code[1], code[2]);
    EXPECT_GT(light, last) << i;
    last = light;
  }
}

TEST(ColorMap, ValuesOutsideAreClamped) {
  EXPECT_EQ(magma(-3.0f), magma(0.0f));
  EXPECT_EQ(magma(7.0f), magma(1.0f));
  EXPECT_EQ(magma(std::numeric_limits<float>::infinity()), magma(1.0f));
  EXPECT_EQ(magma(std::numeric_limits<float>::quiet_NaN()), magma(0.0f));
}

TEST(ColorMap, PictureKeepsItsPixels) {
  ImageF plane(2, 1, 1);
  plane.samples = {0.0f, 1.0f};
  const Image8 picture = in_magma(plane);
  EXPECT_EQ(picture.width, 2u);
  EXPECT_EQ(picture.height, 1u);
  EXPECT_EQ(picture.channels, 3u);
  EXPECT_EQ(picture.samples, (std::vector<uint8_t>{0, 0, 4, 252, 253, 191}));
}

}  // namespace
}  // namespace lueur
