// SPDX-License-Identifier: MIT
#include "image/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/file.h"
#include "image/half.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

ImageLayer layer(const std::string& name, uint32_t channels, uint32_t width = 33,
                 uint32_t height = 21) {
  ImageLayer result{name, ImageF(width, height, channels)};
  for (size_t i = 0; i < result.image.samples.size(); ++i)
    result.image.samples[i] = static_cast<float>((i * 7919) % 2048) / 16.0f;  // exact as halves
  return result;
}

class ExrTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lueur-exr-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    path_ = folder_ / "a.exr";
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::vector<uint8_t> bytes_of(std::span<const ImageLayer> layers,
                                const ExrOptions& options = {}) {
    const auto written = write_exr(path_, layers, options);
    EXPECT_TRUE(written.ok()) << written.error().message;
    return *read_file(path_, 1 << 24);
  }

  // Writes a small file of one half channel with the given header, through the library alone.
  std::vector<uint8_t> bytes_of(Imf::Header header, int sampling = 1) {
    header.channels().insert("Y", Imf::Channel(Imf::HALF, sampling, sampling));
    std::vector<uint16_t> samples(64 * 64, 0x3c00);
    Imf::FrameBuffer frame_buffer;
    frame_buffer.insert("Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(samples.data()), 2, 128,
                                        sampling, sampling));
    {
      Imf::OutputFile file(path_.c_str(), header);
      file.setFrameBuffer(frame_buffer);
      file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
    }
    return *read_file(path_, 1 << 24);
  }

  fs::path folder_;
  fs::path path_;
};

TEST_F(ExrTest, LayersAreReadBack) {
  const std::vector<ImageLayer> layers = {layer("", 4),       layer("albedo", 3),
                                          layer("depth", 1),  layer("motion", 2),
                                          layer("normal", 3), layer("weights", 12)};
  ASSERT_TRUE(write_exr(path_, layers).ok());
  const auto read = read_exr(path_);
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_EQ(read->size(), layers.size());
  for (size_t i = 0; i < layers.size(); ++i) {
    EXPECT_EQ((*read)[i].name, layers[i].name);
    EXPECT_EQ((*read)[i].image.channels, layers[i].image.channels);
    EXPECT_EQ((*read)[i].image.samples, layers[i].image.samples) << layers[i].name;
  }
}

TEST_F(ExrTest, ChannelsAttributesAndTypesAreAsStated) {
  const std::vector<ImageLayer> layers = {layer("", 3), layer("depth", 1), layer("normal", 3),
                                          layer("indirect", 3), layer("motion", 2)};
  ExrOptions options;
  options.attributes = {{"lueur.scene", "cornell"}, {"lueur.exposure", "-1.5"}};
  ASSERT_TRUE(write_exr(path_, layers, options).ok());
  ExrAttributes attributes;
  ASSERT_TRUE(read_exr(path_, &attributes).ok());
  EXPECT_EQ(attributes, options.attributes);

  Imf::InputFile file(path_.c_str());
  const Imf::Header& header = file.header();
  std::vector<std::string> names;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    names.emplace_back(channel.name());
    EXPECT_EQ(channel.channel().type, names.back() == "depth.Z" ? Imf::FLOAT : Imf::HALF);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"B", "G", "R", "depth.Z", "indirect.B", "indirect.G",
                                             "indirect.R", "motion.0", "motion.1", "normal.X",
                                             "normal.Y", "normal.Z"}));
  EXPECT_EQ(header.compression(), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("lueur.scene").value(), "cornell");
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("lueur.exposure").value(), "-1.5");
}

TEST_F(ExrTest, DepthKeepsAllItsBits) {
  std::vector<ImageLayer> layers = {layer("depth", 1, 4, 1), layer("light", 1, 4, 1)};
  layers[0].image.samples = {0.1f, 1e6f, 1e-30f, std::numeric_limits<float>::infinity()};
  layers[1].image.samples = layers[0].image.samples;
  ASSERT_TRUE(write_exr(path_, layers).ok());
  const auto read = read_exr(path_);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ((*read)[0].image.samples, layers[0].image.samples);
  // As halves: rounded, held at the largest, flushed to zero, and infinity kept.
  EXPECT_EQ((*read)[1].image.samples,
            (std::vector<float>{float_from_half(half_from_float(0.1f)), kLargestHalf, 0.0f,
                                std::numeric_limits<float>::infinity()}));
}

TEST_F(ExrTest, NanSurvives) {
  std::vector<ImageLayer> layers = {layer("", 1, 1, 1)};
  layers[0].image.samples = {std::numeric_limits<float>::quiet_NaN()};
  const auto read = decode_exr(bytes_of(layers), "nan");
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(std::isnan((*read)[0].image.samples[0]));
}

TEST_F(ExrTest, SameLayersSameBytes) {
  const std::vector<ImageLayer> layers = {layer("", 3), layer("depth", 1)};
  EXPECT_EQ(bytes_of(layers), bytes_of(layers));
}

TEST_F(ExrTest, ADataWindowMayStartAnywhere) {
  Imf::Header header(Imath::Box2i({0, 0}, {63, 63}), Imath::Box2i({0, 0}, {9, 9}));
  header.compression() = Imf::PIZ_COMPRESSION;
  const auto read = decode_exr(bytes_of(header), "window");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ((*read)[0].image.samples, std::vector<float>(100, 1.0f));
}

TEST_F(ExrTest, UnsupportedKindsAreRefusedByName) {
  const auto refusal = [&](const std::vector<uint8_t>& bytes) {
    const auto read = decode_exr(bytes, "kind.exr");
    if (read.ok()) return std::string();
    EXPECT_EQ(read.error().kind, ErrorKind::input);
    EXPECT_EQ(read.error().message.rfind("kind.exr: ", 0), 0u);
    return read.error().message;
  };
  Imf::Header header(32, 32);
  for (const auto compression : {Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION,
                                 Imf::DWAB_COMPRESSION}) {
    header.compression() = compression;
    EXPECT_NE(refusal(bytes_of(header)).find("B44 and DWA"), std::string::npos);
  }
  header.compression() = Imf::ZIP_COMPRESSION;
  EXPECT_NE(refusal(bytes_of(header, 2)).find("subsampled"), std::string::npos);

  // The flags of the version decide about tiles, depth and parts.
  const auto with_flag = [&](uint8_t flag) {
    std::vector<uint8_t> bytes = bytes_of(header);
    bytes[5] = static_cast<uint8_t>(bytes[5] | flag);
    return bytes;
  };
  EXPECT_NE(refusal(with_flag(0x02)).find("tiled"), std::string::npos);
  EXPECT_NE(refusal(with_flag(0x08)).find("deep"), std::string::npos);
  EXPECT_NE(refusal(with_flag(0x10)).find("multi-part"), std::string::npos);
}

TEST_F(ExrTest, LargeClaimsAreRefusedBeforeMemoryIsTaken) {
  std::vector<uint8_t> bytes = bytes_of(Imf::Header(32, 32));
  const std::string text(bytes.begin(), bytes.end());
  // The value follows the name, the type and 4 bytes of size: set the maximum of x or y in it.
  const std::string head("dataWindow\0box2i\0", 17);
  const size_t value = text.find(head) + head.size() + 4;
  const auto claim = [&](uint32_t width, uint32_t height) {
    const uint32_t max_x = width - 1;
    const uint32_t max_y = height - 1;
    std::memcpy(bytes.data() + value + 8, &max_x, 4);
    std::memcpy(bytes.data() + value + 12, &max_y, 4);
    const auto read = decode_exr(bytes, "claim");
    return read.ok() ? std::string() : read.error().message;
  };
  EXPECT_EQ(claim(32, 32), "");
  EXPECT_NE(claim(16385, 32).find("outside 1 to 16384"), std::string::npos);
  EXPECT_NE(claim(0x7fffffff, 0x7fffffff).find("outside 1 to 16384"), std::string::npos);
  EXPECT_NE(claim(0, 32).find("outside 1 to 16384"), std::string::npos);
  EXPECT_NE(claim(32, 16384).find("cut short"), std::string::npos);
}

// The library reads by the type of an attribute and passes over its size: with another size it
// would take the rest of the header for something else than our check saw, sizes of memory among
// it.
TEST_F(ExrTest, AttributesHaveTheSizeOfTheirType) {
  const std::vector<uint8_t> whole = bytes_of(Imf::Header(32, 32));
  const auto with_a_byte_more = [&](std::string_view head) {
    std::vector<uint8_t> bytes = whole;
    const std::string text(bytes.begin(), bytes.end());
    const size_t size_at = text.find(head) + head.size();
    uint32_t size = 0;
    std::memcpy(&size, bytes.data() + size_at, 4);
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(size_at + 4 + size), uint8_t{1});
    ++size;
    std::memcpy(bytes.data() + size_at, &size, 4);
    const auto read = decode_exr(bytes, "sizes");
    return read.ok() ? std::string() : read.error().message;
  };
  using std::string_view_literals::operator""sv;
  EXPECT_NE(with_a_byte_more("pixelAspectRatio\0float\0"sv).find("wrong size"), std::string::npos);
  EXPECT_NE(with_a_byte_more("lineOrder\0lineOrder\0"sv).find("wrong size"), std::string::npos);
  EXPECT_NE(with_a_byte_more("channels\0chlist\0"sv).find("list of channels"), std::string::npos);
}

TEST_F(ExrTest, EveryTruncationIsRefused) {
  const std::vector<ImageLayer> layers = {layer("", 3, 9, 40), layer("depth", 1, 9, 40)};
  const std::vector<uint8_t> bytes = bytes_of(layers);
  for (size_t length = 0; length < bytes.size(); ++length) {
    const auto read = decode_exr(std::span(bytes).first(length), "cut.exr");
    ASSERT_FALSE(read.ok()) << length << " of " << bytes.size();
    ASSERT_EQ(read.error().message.find('\n'), std::string::npos);
  }
}

TEST_F(ExrTest, DamageIsRefusedOrHarmless) {
  const std::vector<ImageLayer> layers = {layer("", 3, 9, 40), layer("depth", 1, 9, 40)};
  const std::vector<uint8_t> whole = bytes_of(layers);
  for (size_t i = 0; i < whole.size(); ++i) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::vector<uint8_t> bytes = whole;
      bytes[i] = static_cast<uint8_t>(bytes[i] ^ flip);
      const auto read = decode_exr(bytes, "damaged.exr");
      if (!read.ok()) continue;
      for (const ImageLayer& damaged : *read)
        EXPECT_EQ(damaged.image.samples.size(),
                  size_t{damaged.image.width} * damaged.image.height * damaged.image.channels);
    }
  }
}

TEST_F(ExrTest, KnownDamagedFilesDoNoHarm) {
  const char* data = std::getenv("LUEUR_DATA");
  if (data == nullptr) GTEST_SKIP() << "LUEUR_DATA does not name the test data";
  size_t files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(data) / "openexr_images" / "Damaged")) {
    const auto read = read_exr(entry.path());
    if (!read.ok()) {
      EXPECT_EQ(read.error().kind, ErrorKind::input) << read.error().message;
    }
    ++files;
  }
  EXPECT_GT(files, 50u);
}

TEST_F(ExrTest, PicturesOfOthersAreRead) {
  const char* data = std::getenv("LUEUR_DATA");
  if (data == nullptr) GTEST_SKIP() << "LUEUR_DATA does not name the test data";
  const fs::path folder = fs::path(data) / "openexr_images" / "TestImages";
  const auto halves = read_exr(folder / "AllHalfValues.exr");
  ASSERT_TRUE(halves.ok()) << halves.error().message;
  const ImageF& image = halves->front().image;
  EXPECT_EQ(image.width, 256u);
  EXPECT_EQ(image.height, 256u);
  EXPECT_EQ(image.channels, 3u);
  const auto broken = read_exr(folder / "BrightRingsNanInf.exr");
  ASSERT_TRUE(broken.ok()) << broken.error().message;
}

TEST_F(ExrTest, FailuresNameTheFile) {
  const std::vector<ImageLayer> layers = {layer("", 3)};
  const auto missing = write_exr(folder_ / "none" / "a.exr", layers);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::output);
  ExrOptions options;
  options.attributes = {{"compression", "none"}};  // not ours to set
  const auto refused = write_exr(path_, layers, options);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().message.rfind(path_.string(), 0), 0u);
  EXPECT_EQ(read_exr(folder_ / "none.exr").error().kind, ErrorKind::input);
  EXPECT_FALSE(write_exr(path_, std::vector<ImageLayer>{layer("", 3, 0, 0)}).ok());
}

}  // namespace
}  // namespace lueur
