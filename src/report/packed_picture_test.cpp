// SPDX-License-Identifier: MIT
#include "report/packed_picture.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "image/half.h"

namespace lueur::report {
namespace {

std::vector<uint8_t> bytes_of_base64(const std::string& text) {
  std::vector<uint8_t> bytes;
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6 | static_cast<uint32_t>(digits.find(c));
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<uint8_t>(bits >> count));
  }
  return bytes;
}

// Undoes pack_picture() from its description, the slow way: recursion over planes of codes.
class Unpacked {
 public:
  Unpacked(const PackedPicture& packed, uint32_t width, uint32_t height, uint32_t channels)
      : width_(width), count_(size_t{width} * height), channels_(channels) {
    const std::vector<uint8_t> deflated = bytes_of_base64(packed.base64);
    bytes_.resize(2 * count_ * channels);
    uLongf size = bytes_.size();
    EXPECT_EQ(uncompress(bytes_.data(), &size, deflated.data(), deflated.size()), Z_OK);
    EXPECT_EQ(size, bytes_.size());
    for (uint32_t plane = 0; plane < channels; ++plane) planes_.push_back(decode(plane));
  }

  float at(size_t pixel, size_t channel) const {
    int code = planes_[0][pixel];
    if (channels_ == 3 && channel == 0) code += planes_[1][pixel];
    if (channels_ == 3 && channel == 2) code += planes_[2][pixel];
    return float_from_half(static_cast<uint16_t>(code << kDroppedBits));
  }

 private:
  std::vector<int> decode(uint32_t plane) const {
    std::vector<int> values;
    const uint8_t* low = bytes_.data() + plane * 2 * count_;
    for (size_t i = 0; i < count_; ++i) {
      const int folded = low[i] + 256 * low[count_ + i];
      const int miss = folded % 2 != 0 ? -(folded + 1) / 2 : folded / 2;
      values.push_back(miss + prediction(values, i));
    }
    return values;
  }

  int prediction(const std::vector<int>& values, size_t i) const {
    if (i == 0) return 0;
    if (i % width_ == 0) return values[i - width_];
    if (i < width_) return values[i - 1];
    const int left = values[i - 1];
    const int above = values[i - width_];
    const int corner = values[i - width_ - 1];
    if (corner >= std::max(left, above)) return std::min(left, above);
    if (corner <= std::min(left, above)) return std::max(left, above);
    return left + above - corner;
  }

  size_t width_;
  size_t count_;
  uint32_t channels_;
  std::vector<uint8_t> bytes_;
  std::vector<std::vector<int>> planes_;
};

// Values over all exponents of a half float, with neighbours that have nothing in common.
ImageF wild_image(uint32_t width, uint32_t height, uint32_t channels) {
  ImageF image(width, height, channels);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> exponent(-26.0f, 15.9f);
  for (float& sample : image.samples) sample = std::exp2(exponent(random));
  return image;
}

void expect_round_trip(const ImageF& image) {
  const PackedPicture packed = pack_picture(image);
  const Unpacked unpacked(packed, image.width, image.height, image.channels);
  for (size_t i = 0; i < image.samples.size(); ++i) {
    const float value = image.samples[i];
    // As packed_picture.h has it: 2^-9 and 2^-11 of the value; 2^-22 where halves have no more.
    const float bound = value * (std::exp2(-9.0f) + std::exp2(-11.0f)) + std::exp2(-22.0f);
    ASSERT_NEAR(unpacked.at(i / image.channels, i % image.channels), value, bound)
        << "sample " << i;
  }
}

TEST(PackedPicture, ComesBackWithinItsPrecision) {
  expect_round_trip(wild_image(37, 21, 3));
  expect_round_trip(wild_image(37, 21, 1));
}

TEST(PackedPicture, HasNoSmallestSize) {
  expect_round_trip(wild_image(1, 1, 3));
  expect_round_trip(wild_image(1, 1, 1));
  expect_round_trip(wild_image(1, 9, 3));
  expect_round_trip(wild_image(9, 1, 3));
}

TEST(PackedPicture, CodesGrowWithTheValueAndStayFinite) {
  uint16_t before = picture_code(0.0f);
  EXPECT_EQ(before, 0);
  for (float value = 1e-6f; value < 60000.0f; value *= 1.01f) {
    const uint16_t code = picture_code(value);
    EXPECT_GE(code, before);
    before = code;
  }
  for (const float value : {60000.0f, 65504.0f, 1e30f, std::numeric_limits<float>::infinity()}) {
    const float back = float_from_half(static_cast<uint16_t>(picture_code(value) << kDroppedBits));
    EXPECT_GT(back, 59000.0f);
    EXPECT_TRUE(std::isfinite(back));
  }
}

TEST(PackedPicture, CountsSamplesThatNoPictureShouldHave) {
  ImageF image(2, 1, 3);
  image.samples = {std::nanf(""), -1.0f, std::numeric_limits<float>::infinity(), 0.0f, 1.0f, -0.0f};
  const PackedPicture packed = pack_picture(image);
  EXPECT_EQ(packed.replaced, 3u);
  const Unpacked unpacked(packed, 2, 1, 3);
  EXPECT_EQ(unpacked.at(0, 0), 0.0f);
  EXPECT_EQ(unpacked.at(0, 1), 0.0f);
  EXPECT_GT(unpacked.at(0, 2), 60000.0f);
  EXPECT_EQ(unpacked.at(1, 1), 1.0f);
}

// A smooth picture must cost less than its bytes, or prediction does not work.
TEST(PackedPicture, SmoothPicturesAreSmall) {
  ImageF image(256, 256, 3);
  for (uint32_t y = 0; y < 256; ++y)
    for (uint32_t x = 0; x < 256; ++x)
      for (uint32_t c = 0; c < 3; ++c)
        image.at(x, y, c) = 0.1f + 0.01f * static_cast<float>(x + y * (c + 1));
  // One of six bytes of a code's two times three; base64 adds a third.
  EXPECT_LT(pack_picture(image).base64.size(), size_t{256} * 256 * 4 / 3);
}

}  // namespace
}  // namespace lueur::report
