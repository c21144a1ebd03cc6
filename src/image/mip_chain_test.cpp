// SPDX-License-Identifier: MIT
#include "image/mip_chain.h"

#include <gtest/gtest.h>

namespace lueur {
namespace {

// An image of one byte for red, green and blue, and one for alpha.
std::vector<uint8_t> grey(const std::vector<std::pair<uint8_t, uint8_t>>& texels) {
  std::vector<uint8_t> rgba;
  for (const auto& [value, alpha] : texels) rgba.insert(rgba.end(), {value, value, value, alpha});
  return rgba;
}

TEST(MipChain, BlackAndWhiteMixAsLight) {
  const auto checker = grey({{0, 0}, {255, 255}, {255, 255}, {0, 0}});
  // Half the light is code value 188 in sRGB; alpha and data are plain numbers.
  const auto srgb = make_mip_chain(checker, 2, 2, true);
  ASSERT_EQ(srgb.size(), 1u);
  EXPECT_EQ(srgb[0].rgba, grey({{188, 128}}));
  EXPECT_EQ(make_mip_chain(checker, 2, 2, false)[0].rgba, grey({{128, 128}}));
}

TEST(MipChain, EqualTexelsStayAsTheyAre) {
  for (int value = 0; value < 256; ++value) {
    const std::pair<uint8_t, uint8_t> texel(value, 255 - value);
    for (const bool srgb : {true, false}) {
      const auto levels = make_mip_chain(grey({texel, texel, texel, texel}), 2, 2, srgb);
      EXPECT_EQ(levels[0].rgba, grey({texel})) << value << (srgb ? " sRGB" : " linear");
    }
  }
}

TEST(MipChain, OnePixelHasNoFurtherLevel) {
  EXPECT_TRUE(make_mip_chain(grey({{7, 9}}), 1, 1, true).empty());
}

TEST(MipChain, OddSizesRoundDownToOne) {
  const auto odd = make_mip_chain(std::vector<uint8_t>(5 * 3 * 4, 100), 5, 3, true);
  ASSERT_EQ(odd.size(), 2u);
  EXPECT_EQ(odd[0].width, 2u);
  EXPECT_EQ(odd[0].height, 1u);
  EXPECT_EQ(odd[0].rgba.size(), 2u * 4);
  EXPECT_EQ(odd[1].width, 1u);
  EXPECT_EQ(odd[1].height, 1u);
  EXPECT_EQ(odd[1].rgba, std::vector<uint8_t>(4, 100));
  // A row of 3: the first two texels are averaged.
  const auto row = make_mip_chain(grey({{10, 0}, {20, 0}, {90, 0}}), 3, 1, false);
  ASSERT_EQ(row.size(), 1u);
  EXPECT_EQ(row[0].rgba, grey({{15, 0}}));
  const auto column = make_mip_chain(grey({{10, 0}, {20, 0}, {40, 0}, {50, 0}}), 1, 4, false);
  ASSERT_EQ(column.size(), 2u);
  EXPECT_EQ(column[0].rgba, grey({{15, 0}, {45, 0}}));
  EXPECT_EQ(column[1].rgba, grey({{30, 0}}));
}

}  // namespace
}  // namespace lueur
