// SPDX-License-Identifier: MIT
#include "image/hdr.h"

#include <gtest/gtest.h>

#include <string>

namespace lueur {
namespace {

const std::string kHeader = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n";

Result<ImageF> decode(const std::string& text) {
  return decode_hdr(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()), "x.hdr");
}

std::string file_of(const std::string& size, const std::string& pixels) {
  return kHeader + "\n" + size + "\n" + pixels;
}

// A pixel whose red is `red` / 256 * 2^(e - 128); with e = 136 that is `red`.
std::string pixel(int red, int exponent = 136) {
  return {static_cast<char>(red), 0, 7, static_cast<char>(exponent)};
}

void expect_refused(const std::string& text, const std::string& part) {
  const auto image = decode(text);
  ASSERT_FALSE(image.ok()) << part;
  EXPECT_EQ(image.error().kind, ErrorKind::input);
  EXPECT_TRUE(image.error().message.starts_with("x.hdr: ")) << image.error().message;
  EXPECT_NE(image.error().message.find(part), std::string::npos) << image.error().message;
  EXPECT_EQ(image.error().message.find('\n'), std::string::npos);
}

TEST(Hdr, FlatPixelsAndTheirExponents) {
  const auto image = decode(file_of("-Y 1 +X 3", pixel(5) + pixel(5, 137) + pixel(5, 0)));
  ASSERT_TRUE(image.ok()) << image.error().message;
  EXPECT_EQ(image->channels, 3u);
  EXPECT_EQ(image->at(0, 0, 0), 5.0f);
  EXPECT_EQ(image->at(0, 0, 1), 0.0f);
  EXPECT_EQ(image->at(0, 0, 2), 7.0f);
  EXPECT_EQ(image->at(1, 0, 0), 10.0f);
  EXPECT_EQ(image->at(2, 0, 2), 0.0f);
}

TEST(Hdr, OldRunsRepeatPixels) {
  // One pixel, then 2 + 1 * 256 more of it, then another one.
  const std::string one(3, '\1');
  const auto image = decode(file_of("-Y 1 +X 260", pixel(9) + one + '\2' + one + '\1' + pixel(4)));
  ASSERT_TRUE(image.ok()) << image.error().message;
  for (uint32_t x = 0; x < 259; ++x) ASSERT_EQ(image->at(x, 0, 0), 9.0f) << x;
  EXPECT_EQ(image->at(259, 0, 0), 4.0f);
}

// A line of 8 pixels in the new encoding: reds 1 to 8 one by one, the rest as runs.
std::string new_line() {
  std::string line = {2, 2, 0, 8, 8, 1, 2, 3, 4, 5, 6, 7, 8};
  line += {static_cast<char>(136), 0};
  line += {static_cast<char>(131), 3, static_cast<char>(133), 5};
  line += {static_cast<char>(136), static_cast<char>(136)};
  return line;
}

TEST(Hdr, NewRunsGoByChannel) {
  const auto image = decode(file_of("-Y 2 +X 8", new_line() + new_line()));
  ASSERT_TRUE(image.ok()) << image.error().message;
  for (uint32_t x = 0; x < 8; ++x) {
    EXPECT_EQ(image->at(x, 1, 0), static_cast<float>(x + 1));
    EXPECT_EQ(image->at(x, 1, 2), x < 3 ? 3.0f : 5.0f);
  }
}

TEST(Hdr, AllEightOrdersOfAxes) {
  // In the file's order 1 2 3 / 4 5 6; for each layout what the picture is, row by row.
  const struct {
    const char* size;
    uint32_t width;
    std::array<float, 6> picture;
  } cases[] = {
      {"-Y 2 +X 3", 3, {1, 2, 3, 4, 5, 6}}, {"-Y 2 -X 3", 3, {3, 2, 1, 6, 5, 4}},
      {"+Y 2 +X 3", 3, {4, 5, 6, 1, 2, 3}}, {"+Y 2 -X 3", 3, {6, 5, 4, 3, 2, 1}},
      {"+X 2 -Y 3", 2, {1, 4, 2, 5, 3, 6}}, {"-X 2 -Y 3", 2, {4, 1, 5, 2, 6, 3}},
      {"+X 2 +Y 3", 2, {3, 6, 2, 5, 1, 4}}, {"-X 2 +Y 3", 2, {6, 3, 5, 2, 4, 1}},
  };
  std::string pixels;
  for (int i = 1; i <= 6; ++i) pixels += pixel(i);
  for (const auto& c : cases) {
    const auto image = decode(file_of(c.size, pixels));
    ASSERT_TRUE(image.ok()) << c.size;
    EXPECT_EQ(image->width, c.width) << c.size;
    for (uint32_t i = 0; i < 6; ++i)
      EXPECT_EQ(image->at(i % c.width, i / c.width, 0), c.picture[i]) << c.size << " " << i;
  }
}

TEST(Hdr, ExposureIsDividedOut) {
  const auto image =
      decode("#?RGBE\r\nEXPOSURE=2\nEXPOSURE= 4\nCOLORCORR=1 1 0.5\n\n-Y 1 +X 1\n" + pixel(16));
  ASSERT_TRUE(image.ok()) << image.error().message;
  EXPECT_EQ(image->at(0, 0, 0), 2.0f);
  EXPECT_EQ(image->at(0, 0, 2), 7.0f / 4.0f);
}

TEST(Hdr, HostileFilesAreRefused) {
  expect_refused("", "does not start");
  expect_refused("#?RADIANCE\n", "header is cut short");
  expect_refused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel(1), "XYZE");
  expect_refused("#?RADIANCE\nFORMAT=nonsense\n\n-Y 1 +X 1\n" + pixel(1), "nonsense");
  for (const std::string exposure : {"0", "-1", "nan", "1e300", "x", ""})
    expect_refused("#?RADIANCE\nEXPOSURE=" + exposure + "\n\n-Y 1 +X 1\n" + pixel(1), "EXPOSURE");
  expect_refused(file_of("", pixel(1)), "size");
  expect_refused(file_of("-Y 1", pixel(1)), "size");
  expect_refused(file_of("-Y 1 +Y 1", pixel(1)), "one axis twice");
  expect_refused(file_of("-Y 0 +X 1", pixel(1)), "0 pixels");
  expect_refused(file_of("-Y 16385 +X 1", pixel(1)), "16385 pixels");
  expect_refused(file_of("-Y 16384 +X 16384", pixel(1)), "67108864 together");
  expect_refused(file_of("-Y 99999999999 +X 1", pixel(1)), "not a number");
  expect_refused(file_of("-Y 16384 +X 4096", pixel(1)), "cut short");
  const std::string one(3, '\1');
  expect_refused(file_of("-Y 1 +X 4", one + '\1'), "leads out");
  expect_refused(file_of("-Y 1 +X 4", pixel(1) + one + '\4'), "leads out");
  expect_refused(file_of("-Y 1 +X 4",
                         pixel(1) + one + '\0' + one + '\0' + one + '\0' + one + '\0' + one + '\0'),
                 "leads out");
  expect_refused(file_of("-Y 1 +X 9", new_line()), "another length");
  std::string line = new_line();
  line[4] = 9;
  expect_refused(file_of("-Y 1 +X 8", line), "leads out");
  line[4] = 0;
  expect_refused(file_of("-Y 1 +X 8", line), "leads out");
  const std::string whole = file_of("-Y 1 +X 8", new_line());
  for (size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(decode(whole.substr(0, size)).ok()) << size;
}

}  // namespace
}  // namespace lueur
