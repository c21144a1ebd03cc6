// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>

#include "base/file.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

class PngTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lueur-png-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

Image8 gradient(uint32_t width, uint32_t height, uint32_t channels) {
  Image8 image{width, height, channels, {}};
  for (size_t i = 0; i < size_t{width} * height * channels; ++i)
    image.samples.push_back(static_cast<uint8_t>(i * 37 + i / 11));
  return image;
}

// Encodes rows of raw samples in any colour type and depth, to have more to read than we write.
std::vector<uint8_t> encode_raw(uint32_t width, uint32_t height, int depth, int color_type,
                                std::vector<uint8_t> rows, int interlace = PNG_INTERLACE_NONE) {
  std::vector<uint8_t> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp writer, png_bytep data, size_t count) {
        auto& out = *static_cast<std::vector<uint8_t>*>(png_get_io_ptr(writer));
        out.insert(out.end(), data, data + count);
      },
      nullptr);
  png_set_IHDR(png, info, width, height, depth, color_type, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (color_type == PNG_COLOR_TYPE_PALETTE) {
    const png_color palette[2] = {{10, 20, 30}, {40, 50, 60}};
    const png_byte alpha[1] = {128};
    png_set_PLTE(png, info, palette, 2);
    png_set_tRNS(png, info, alpha, 1, nullptr);
  }
  png_set_gAMA(png, info, 1.0);  // must not change the samples
  png_write_info(png, info);
  std::vector<png_bytep> row_pointers;
  for (uint32_t y = 0; y < height; ++y)
    row_pointers.push_back(rows.data() + y * png_get_rowbytes(png, info));
  png_write_image(png, row_pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

TEST_F(PngTest, WhatIsWrittenIsReadBack) {
  for (const uint32_t channels : {3u, 4u}) {
    const Image8 image = gradient(37, 11, channels);
    ASSERT_TRUE(write_png(folder_ / "a.png", image).ok());
    const auto read = read_png(folder_ / "a.png");
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_EQ(read->channels, 4u);
    ASSERT_EQ(read->samples.size(), 37u * 11 * 4);
    for (size_t pixel = 0; pixel < 37u * 11; ++pixel) {
      for (size_t c = 0; c < channels; ++c)
        ASSERT_EQ(read->samples[pixel * 4 + c], image.samples[pixel * channels + c]);
      if (channels == 3) {
        ASSERT_EQ(read->samples[pixel * 4 + 3], 255);
      }
    }
  }
}

TEST_F(PngTest, SamePictureSameBytes) {
  ASSERT_TRUE(write_png(folder_ / "a.png", gradient(20, 20, 3)).ok());
  ASSERT_TRUE(write_png(folder_ / "b.png", gradient(20, 20, 3)).ok());
  EXPECT_EQ(*read_file(folder_ / "a.png", 1 << 20), *read_file(folder_ / "b.png", 1 << 20));
}

TEST_F(PngTest, EveryKindBecomesRgba) {
  using Bytes = std::vector<uint8_t>;
  const auto rgba = [](const Bytes& bytes) {
    const auto image = decode_png(bytes, "test");
    return image.ok() ? image->samples : Bytes{};
  };
  EXPECT_EQ(rgba(encode_raw(2, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 200})),
            (Bytes{0, 0, 0, 255, 200, 200, 200, 255}));
  EXPECT_EQ(rgba(encode_raw(2, 1, 1, PNG_COLOR_TYPE_GRAY, {0x40})),
            (Bytes{0, 0, 0, 255, 255, 255, 255, 255}));
  EXPECT_EQ(rgba(encode_raw(1, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {9, 77})), (Bytes{9, 9, 9, 77}));
  EXPECT_EQ(rgba(encode_raw(1, 1, 16, PNG_COLOR_TYPE_RGB, {0x12, 0x34, 0x80, 0x80, 0xff, 0xff})),
            (Bytes{0x12, 0x80, 0xff, 255}));
  EXPECT_EQ(rgba(encode_raw(2, 1, 1, PNG_COLOR_TYPE_PALETTE, {0x40})),
            (Bytes{10, 20, 30, 128, 40, 50, 60, 255}));
}

TEST_F(PngTest, InterlacedReadsTheSame) {
  const Image8 image = gradient(13, 9, 4);
  const auto plain = decode_png(encode_raw(13, 9, 8, PNG_COLOR_TYPE_RGBA, image.samples), "plain");
  const auto interlaced = decode_png(
      encode_raw(13, 9, 8, PNG_COLOR_TYPE_RGBA, image.samples, PNG_INTERLACE_ADAM7), "interlaced");
  ASSERT_TRUE(plain.ok());
  ASSERT_TRUE(interlaced.ok());
  EXPECT_EQ(plain->samples, image.samples);
  EXPECT_EQ(interlaced->samples, image.samples);
}

TEST_F(PngTest, EveryTruncationIsRefusedAndNamed) {
  const auto bytes = encode_raw(13, 9, 8, PNG_COLOR_TYPE_RGBA, gradient(13, 9, 4).samples);
  for (size_t length = 0; length < bytes.size(); ++length) {
    const auto image = decode_png(std::span(bytes).first(length), "cut.png");
    ASSERT_FALSE(image.ok()) << length;
    ASSERT_EQ(image.error().kind, ErrorKind::input);
    ASSERT_EQ(image.error().message.rfind("cut.png: ", 0), 0u);
    ASSERT_EQ(image.error().message.find('\n'), std::string::npos);
  }
}

TEST_F(PngTest, DamageIsRefusedOrHarmless) {
  const auto whole = encode_raw(13, 9, 8, PNG_COLOR_TYPE_RGBA, gradient(13, 9, 4).samples);
  for (size_t i = 0; i < whole.size(); ++i) {
    auto bytes = whole;
    bytes[i] ^= 0x55;
    const auto image = decode_png(bytes, "damaged.png");
    if (image.ok()) {
      EXPECT_EQ(image->samples.size(), 13u * 9 * 4) << i;
    }
  }
}

TEST_F(PngTest, LargeClaimsAreRefusedBeforeMemoryIsTaken) {
  // A row of zeros is a valid start of each of these; the header alone decides.
  const auto claim = [](uint32_t width, uint32_t height) {
    std::vector<uint8_t> bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp writer, png_bytep data, size_t count) {
          auto& out = *static_cast<std::vector<uint8_t>*>(png_get_io_ptr(writer));
          out.insert(out.end(), data, data + count);
        },
        nullptr);
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    const uint8_t empty_idat[] = {0, 0, 0, 0, 'I', 'D', 'A', 'T', 0x35, 0xaf, 0x06, 0x1e};
    bytes.insert(bytes.end(), std::begin(empty_idat), std::end(empty_idat));
    png_destroy_write_struct(&png, &info);
    const auto image = decode_png(bytes, "claim.png");
    return image.ok() ? std::string() : image.error().message;
  };
  EXPECT_NE(claim(16385, 1).find("claim.png"), std::string::npos);
  EXPECT_NE(claim(16384, 16384).find("more than the limit"), std::string::npos);
  EXPECT_NE(claim(8192, 8192).find("cut short"), std::string::npos);
}

TEST_F(PngTest, FailuresNameTheFile) {
  EXPECT_EQ(read_png(folder_ / "none.png").error().kind, ErrorKind::input);
  const auto written = write_png(folder_ / "none" / "a.png", gradient(2, 2, 3));
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::output);
  EXPECT_FALSE(write_png(folder_ / "empty.png", Image8{0, 0, 3, {}}).ok());
}

}  // namespace
}  // namespace lueur
