// SPDX-License-Identifier: MIT
// Looking into passes: what comes back from the device, watched images and the scan.
#include <cmath>
#include <cstring>
#include <limits>

#include "frame/recorder.h"
#include "frame/test_shaders/params.h"
#include "frame/test_shaders/shaders.h"
#include "gpu/format.h"
#include "image/half.h"
#include "image/tone_map.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class RecorderImageTest : public GpuTest {
 protected:
  void copy(const std::string& pass, Image from, Image to) {
    recorder().dispatch(pass, {.shader = shaders::frame_test_shaders_copy_comp,
                               .params = CopyParams{as_ivec2(to.extent), 0.0f},
                               .read = {{"from", from}},
                               .write = {{"to", to}},
                               .over = to.extent});
  }
  // Brings `values` to the device in `format`; what comes back directly, and what a sampler sees.
  template <class T>
  void round_trip(Format format, const std::vector<T>& values) {
    const uint32_t channels = gpu::info(format).channels;
    const bool is_integer = format == Format::r32ui || format == Format::rgba32ui;
    const Extent extent{static_cast<uint32_t>(values.size()) / channels, 1};
    run([&](Frame&) {
      const Image image = recorder().upload_image("image", extent, format, values.data());
      recorder().read_back("back", image);
      if (is_integer) return;
      recorder().options.scan = false;
      const Image seen = recorder().image("seen", extent, Format::rgba32f);
      copy("test.copy", image, seen);
      recorder().read_back("seen", seen);
    });
    back_ = pixels("back");
    EXPECT_EQ(back_.channels, channels);
    EXPECT_EQ(back_.extent, extent);
    if (!is_integer) seen_ = pixels("seen");
  }
  // Both ways give `expected`; channels that the format lacks read as 0, 0, 1.
  void expect_values(const std::vector<float>& expected, float tolerance = 0.0f) {
    ASSERT_EQ(back_.samples.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(back_.samples[i], expected[i]) << i;
      const size_t pixel = i / back_.channels, channel = i % back_.channels;
      EXPECT_NEAR(seen_.samples[4 * pixel + channel], expected[i], tolerance) << i;
    }
    for (uint32_t c = back_.channels; c < 4; ++c) EXPECT_EQ(seen_.samples[c], c == 3 ? 1.0f : 0.0f);
  }

  Pixels back_;
  Pixels seen_;
};

std::vector<float> over_255(const std::vector<uint8_t>& values) {
  std::vector<float> result;
  for (const uint8_t v : values) result.push_back(static_cast<float>(v) / 255.0f);
  return result;
}

TEST_F(RecorderImageTest, EightBitFormatsComeBack) {
  const std::vector<uint8_t> bytes = {0, 1, 127, 128, 200, 254, 255, 3};
  for (const Format format : {Format::r8, Format::rg8, Format::rgba8}) {
    SCOPED_TRACE(gpu::info(format).name);
    round_trip(format, bytes);
    expect_values(over_255(bytes), 1e-6f);
  }
}

TEST_F(RecorderImageTest, SrgbComesBackEncodedAndIsSeenDecoded) {
  const std::vector<uint8_t> bytes = {0, 10, 128, 255, 188, 55, 254, 64};
  round_trip(Format::rgba8_srgb, bytes);
  EXPECT_EQ(back_.samples, over_255(bytes));
  for (size_t i = 0; i < bytes.size(); ++i) {
    const float encoded = static_cast<float>(bytes[i]) / 255.0f;
    EXPECT_NEAR(seen_.samples[i], i % 4 == 3 ? encoded : linear_from_srgb(encoded), 1e-3f) << i;
  }
}

TEST_F(RecorderImageTest, SnormComesBack) {
  round_trip<int16_t>(Format::rg16_snorm, {32767, -32767, -32768, 0, 16384, -1});
  expect_values({1.0f, -1.0f, -1.0f, 0.0f, 16384.0f / 32767.0f, -1.0f / 32767.0f}, 1e-6f);
}

TEST_F(RecorderImageTest, HalfFloatsComeBack) {
  // Largest, smallest normal and subnormal, and numbers a half can hold.
  const std::vector<float> values = {
      0.0f,    1.0f, -2.5f, 65504.0f, std::ldexp(1.0f, -14), std::ldexp(1.0f, -24), 0.333251953125f,
      -1024.0f};
  std::vector<uint16_t> halves;
  for (const float v : values) halves.push_back(half_from_float(v));
  for (const Format format : {Format::r16f, Format::rg16f, Format::rgba16f}) {
    SCOPED_TRACE(gpu::info(format).name);
    round_trip(format, halves);
    expect_values(values);
  }
  // What is not a number stays so.
  round_trip(Format::r16f,
             std::vector<uint16_t>{half_from_float(kNan), half_from_float(kInfinity)});
  EXPECT_TRUE(std::isnan(back_.samples[0]));
  EXPECT_EQ(back_.samples[1], kInfinity);
}

TEST_F(RecorderImageTest, FloatsAndIntegersComeBack) {
  const std::vector<float> values = {0.1f, -3e30f, 1e-30f, 16777217.0f, 5, 6, 7, 8};
  for (const Format format : {Format::r32f, Format::rgba32f}) {
    SCOPED_TRACE(gpu::info(format).name);
    round_trip(format, values);
    expect_values(values);
  }
  round_trip<uint32_t>(Format::r32ui, {0, 1, 4'000'000'000u});
  EXPECT_EQ(back_.samples, (std::vector<float>{0.0f, 1.0f, 4e9f}));
  round_trip<uint32_t>(Format::rgba32ui, {0, 1, 2, 4'000'000'000u});
  EXPECT_EQ(back_.samples, (std::vector<float>{0.0f, 1.0f, 2.0f, 4e9f}));
}

// Several draws into the same integer image: each keeps what the one before left.
TEST_F(RecorderImageTest, LogicOperationsCombineBits) {
  if (!recorder().has_logic_op()) GTEST_SKIP() << "the device has no logicOp";
  constexpr Extent kExtent{4, 2};
  run([&](Frame&) {
    const Image bits = recorder().image("bits", kExtent, Format::rgba32ui);
    const auto draw = [&](const char* pass, gpu::LogicOp op, vec4 value, bool keep) {
      // One triangle over the left half, see fill.vert.
      recorder().draw(pass, {.state = {.vertex = &shaders::frame_test_shaders_fill_vert,
                                       .fragment = &shaders::frame_test_shaders_bits_frag,
                                       .logic_op = op},
                             .params = FillParams{value, 0.5f},
                             .color = {{.name = "bits", .image = bits, .keep = keep}},
                             .record = [](DrawList& list) {
                               list.cull_back_faces(false);
                               list.vertices(3);
                             }});
    };
    draw("test.xor", gpu::LogicOp::bit_xor, vec4(12.0f, 1.0f, 0.0f, 7.0f), false);
    draw("test.xor_again", gpu::LogicOp::bit_xor, vec4(10.0f, 1.0f, 0.0f, 0.0f), true);
    draw("test.or", gpu::LogicOp::bit_or, vec4(1.0f, 0.0f, 5.0f, 8.0f), true);
    recorder().read_back("bits", bits);
  });
  const Pixels bits = pixels("bits");
  for (uint32_t i = 0; i < kExtent.width * kExtent.height; ++i) {
    const bool is_drawn = i % kExtent.width < kExtent.width / 2;
    const std::vector<float> expected =
        is_drawn ? std::vector<float>{7, 0, 5, 15} : std::vector<float>{0, 0, 0, 0};
    EXPECT_EQ(std::vector(&bits.samples[4 * i], &bits.samples[4 * i] + 4), expected) << i;
  }
}

TEST_F(RecorderImageTest, DrawnColorAndDepthComeBack) {
  constexpr Extent kExtent{6, 4};
  run([&](Frame&) {
    const Image color = recorder().image("color", kExtent, Format::rgba16f);
    const Image depth = recorder().image("depth", kExtent, Format::d32f);
    const Image seen = recorder().image("seen", kExtent, Format::rgba32f);
    const FillParams params{vec4(0.5f, 2.0f, 3.0f, 1.0f), 0.3f};
    recorder().draw("test.fill", {.state = {.vertex = &shaders::frame_test_shaders_fill_vert,
                                            .fragment = &shaders::frame_test_shaders_fill_frag,
                                            .depth_test = gpu::DepthTest::nearer_reversed},
                                  .params = params,
                                  .color = {{"color", color, {9, 8, 7, 6}}},
                                  .depth = DrawTarget{"depth", depth, {0.125f}},
                                  .record = [](DrawList& list) { list.fullscreen_triangle(); }});
    copy("test.copy", depth, seen);
    recorder().read_back("color", color);
    recorder().read_back("depth", depth);
    recorder().read_back("seen", seen);
  });
  const Pixels color = pixels("color"), depth = pixels("depth"), seen = pixels("seen");
  ASSERT_EQ(depth.channels, 1u);
  for (uint32_t i = 0; i < 24; ++i) {
    const bool drawn = i % 6 < 3;  // the triangle covers the left half
    EXPECT_EQ(color.samples[4 * i], drawn ? 0.5f : 9.0f) << i;
    EXPECT_EQ(color.samples[4 * i + 2], drawn ? 3.0f : 7.0f) << i;
    EXPECT_EQ(depth.samples[i], drawn ? 0.3f : 0.125f) << i;
    EXPECT_EQ(seen.samples[4 * i], drawn ? 0.3f : 0.125f) << i;
  }
}

TEST_F(RecorderImageTest, WatchedImagesAreCaptured) {
  const auto captured = [&](std::vector<std::string> watch) {
    recorder().options.watch = std::move(watch);
    run([&](Frame&) {
      const std::vector<float> ones(4 * 4, 1.0f);
      const Image from = recorder().upload_image("from", {2, 2}, Format::rgba32f, ones.data());
      const Image light = recorder().image("light", {2, 2}, Format::rgba32f);
      const Image normal = recorder().image("normal", {2, 2}, Format::rgba32f);
      recorder().dispatch("split.near", {.shader = shaders::frame_test_shaders_split_comp,
                                         .params = CopyParams{ivec2(2, 2), 0.0f},
                                         .read = {{"from", from}},
                                         .write = {{"light", light}, {"normal", normal}},
                                         .over = {2, 2}});
      copy("copy.far", light, normal);
    });
    std::vector<std::string> names;
    for (const Pixels& p : recorder().read_back_pixels()) {
      names.push_back(p.name);
      EXPECT_EQ(p.samples, std::vector<float>(16, 1.0f));
    }
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(captured({}), Names{});
  EXPECT_EQ(recorder().written_images(),
            (Names{"split.near.light", "split.near.normal", "copy.far.to"}));
  EXPECT_EQ(captured({"split.near.light"}), Names{"split.near.light"});
  EXPECT_EQ(captured({"split.near"}), (Names{"split.near.light", "split.near.normal"}));
  EXPECT_EQ(captured({"*.normal", "copy.*"}), (Names{"split.near.normal", "copy.far.to"}));
  EXPECT_EQ(captured({"*"}), (Names{"split.near.light", "split.near.normal", "copy.far.to"}));
  EXPECT_EQ(captured({"split", "*.ligh", "near.light", "split.near.light2"}), Names{});
  EXPECT_EQ(captured({"s*t.*a*.l*t"}), Names{"split.near.light"});
}

TEST_F(RecorderImageTest, ScanFindsWhatCannotBeLight) {
  constexpr Extent kExtent{5, 4};
  // By pixel: negative at (3, 1), infinite at (0, 2), NaN at (4, 2) and again at (1, 3).
  std::vector<vec4> values(20, vec4(1.0f));
  values[8].y = -0.5f;
  values[10].x = kInfinity;
  values[14].z = kNan;
  values[16].w = kNan;
  values[17] = vec4(-0.0f);  // is zero
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    const Image from = recorder().upload_image("from", kExtent, Format::rgba32f, values.data());
    const Image light = recorder().image("light", kExtent, Format::rgba32f);
    const Image normal = recorder().image("normal", kExtent, Format::rgba32f);
    recorder().dispatch("test.split", {.shader = shaders::frame_test_shaders_split_comp,
                                       .params = CopyParams{as_ivec2(kExtent), 0.0f},
                                       .read = {{"from", from}},
                                       .write = {{"light", light}, {"normal", normal}},
                                       .over = kExtent});
    return frame.finish();
  });
  ASSERT_TRUE(result.ok()) << result.error().message;
  const std::vector<ScanFinding> findings = recorder().scan_findings();
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].image, "test.split.light");
  EXPECT_EQ(findings[0].nan, 2u);
  EXPECT_EQ(findings[0].infinite, 1u);
  EXPECT_EQ(findings[0].negative, 1u);
  EXPECT_EQ(findings[0].first_x, 3u);
  EXPECT_EQ(findings[0].first_y, 1u);
  // Normals may be negative.
  EXPECT_EQ(findings[1].image, "test.split.normal");
  EXPECT_EQ(findings[1].nan, 2u);
  EXPECT_EQ(findings[1].negative, 0u);
  EXPECT_EQ(findings[1].first_x, 0u);
  EXPECT_EQ(findings[1].first_y, 2u);

  // The next frame is judged anew.
  run([&](Frame&) {
    const Image from = recorder().upload_image("from", {1, 1}, Format::rgba32f, &values[0]);
    const Image to = recorder().image("to", {1, 1}, Format::rgba32f);
    copy("test.copy", from, to);
  });
  EXPECT_TRUE(recorder().scan_findings().empty());
}

}  // namespace
}  // namespace lueur
