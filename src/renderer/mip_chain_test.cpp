// SPDX-License-Identifier: MIT
#include "renderer/mip_chain.h"

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
  const MipChain srgb = make_mip_chain(checker, {2, 2}, true);
  ASSERT_EQ(srgb.levels.size(), 1u);
  EXPECT_EQ(srgb.levels[0], grey({{188, 128}}));
  const MipChain linear = make_mip_chain(checker, {2, 2}, false);
  EXPECT_EQ(linear.levels[0], grey({{128, 128}}));
}

TEST(MipChain, EqualTexelsStayAsTheyAre) {
  for (int value = 0; value < 256; ++value) {
    const std::pair<uint8_t, uint8_t> texel(value, 255 - value);
    for (const bool srgb : {true, false}) {
      const MipChain chain = make_mip_chain(grey({texel, texel, texel, texel}), {2, 2}, srgb);
      EXPECT_EQ(chain.levels[0], grey({texel})) << value << (srgb ? " sRGB" : " linear");
    }
  }
}

TEST(MipChain, OnePixelHasNoFurtherLevel) {
  const MipChain chain = make_mip_chain(grey({{7, 9}}), {1, 1}, true);
  EXPECT_TRUE(chain.levels.empty());
  EXPECT_EQ(chain.extents, (std::vector<Extent>{{1, 1}}));
}

TEST(MipChain, OddSizesRoundDownToOne) {
  const MipChain chain = make_mip_chain(std::vector<uint8_t>(5 * 3 * 4, 100), {5, 3}, true);
  EXPECT_EQ(chain.extents, (std::vector<Extent>{{5, 3}, {2, 1}, {1, 1}}));
  ASSERT_EQ(chain.levels.size(), 2u);
  EXPECT_EQ(chain.levels[0].size(), 2u * 4);
  EXPECT_EQ(chain.levels[1], std::vector<uint8_t>(4, 100));
  // A row of 3: the first two texels are averaged.
  const MipChain row = make_mip_chain(grey({{10, 0}, {20, 0}, {90, 0}}), {3, 1}, false);
  EXPECT_EQ(row.extents, (std::vector<Extent>{{3, 1}, {1, 1}}));
  EXPECT_EQ(row.levels[0], grey({{15, 0}}));
  const MipChain column = make_mip_chain(grey({{10, 0}, {20, 0}, {40, 0}, {50, 0}}), {1, 4}, false);
  EXPECT_EQ(column.extents, (std::vector<Extent>{{1, 4}, {1, 2}, {1, 1}}));
  EXPECT_EQ(column.levels[0], grey({{15, 0}, {45, 0}}));
  EXPECT_EQ(column.levels[1], grey({{30, 0}}));
}

}  // namespace
}  // namespace lueur
