// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <gtest/gtest.h>

namespace lueur {
namespace {

Image8 two_pixels(std::vector<uint8_t> samples) {
  return {2, 1, 3, std::move(samples)};
}

TEST(Compare, EqualPicturesDoNotDiffer) {
  const Image8 image = two_pixels({1, 2, 3, 4, 5, 6});
  const auto difference = compare(image, image, 0);
  ASSERT_TRUE(difference.ok());
  EXPECT_EQ(difference->share_over, 0.0);
  EXPECT_EQ(difference->max_channel, 0);
}

TEST(Compare, OnePixelOfTwoIsOver) {
  const Image8 a = two_pixels({0, 0, 0, 10, 10, 10});
  const Image8 b = two_pixels({0, 3, 4, 10, 10, 22});
  const auto difference = compare(a, b, 4);
  ASSERT_TRUE(difference.ok());
  EXPECT_EQ(difference->share_over, 0.5);  // a difference of exactly the tolerance is within it
  EXPECT_EQ(difference->max_channel, 12);
  EXPECT_EQ(compare(a, b, 3)->share_over, 1.0);
  EXPECT_EQ(compare(b, a, 12)->share_over, 0.0);
}

TEST(Compare, TheLargestDifferenceFits) {
  const auto difference =
      compare(two_pixels({0, 0, 0, 0, 0, 0}), two_pixels({255, 255, 255, 255, 255, 255}), 254);
  ASSERT_TRUE(difference.ok());
  EXPECT_EQ(difference->share_over, 1.0);
  EXPECT_EQ(difference->max_channel, 255);
}

TEST(Compare, ShapesMustMatch) {
  const Image8 wide = two_pixels({1, 2, 3, 4, 5, 6});
  const Image8 high = {1, 2, 3, {1, 2, 3, 4, 5, 6}};
  ASSERT_FALSE(compare(wide, high, 0).ok());
  EXPECT_EQ(compare(wide, high, 0).error().kind, ErrorKind::input);
  EXPECT_NE(compare(wide, high, 0).error().message.find("2x1"), std::string::npos);
}

}  // namespace
}  // namespace lueur
