// SPDX-License-Identifier: MIT
// `lueur diff` as a user and a script meet it.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "image/exr.h"
#include "image/png.h"
#include "support/cli.h"

namespace lueur {
namespace {

// Writes a grey picture of 16x12 as a display shows it, and one of light with layers: the main
// picture `light`, `indirect` half of it, and `depth`, which is 0 in the left half, where `light`
// is wrong by a factor of 10.
void write_grey_png(const fs::path& path, uint8_t code) {
  Image8 image{16, 12, 3, {}};
  image.samples.assign(size_t{16} * 12 * 3, code);
  ASSERT_TRUE(write_png(path, image).ok());
}

// A main picture of light, which is `left` times as bright in its left half; `indirect`, half of
// it; and `depth`, which is 0 in the left half.
void write_light_exr(const fs::path& path, float light, float left = 1.0f) {
  ImageF main(16, 12, 3), indirect(16, 12, 3), depth(16, 12, 1);
  for (uint32_t y = 0; y < 12; ++y)
    for (uint32_t x = 0; x < 16; ++x) {
      for (uint32_t c = 0; c < 3; ++c) {
        main.at(x, y, c) = x < 8 ? left * light : light;
        indirect.at(x, y, c) = 0.5f * main.at(x, y, c);
      }
      depth.at(x, y, 0) = x < 8 ? 0.0f : 3.0f;
    }
  const ImageLayer layers[] = {{"", main}, {"indirect", indirect}, {"depth", depth}};
  ASSERT_TRUE(write_exr(path, layers).ok());
}

TEST_F(Cli, DiffReport) {
  write_grey_png(folder_ / "a.png", 151);
  write_grey_png(folder_ / "b.png", 100);
  const Ended ended = run({"diff", "a.png", "b.png", "--json", "-o", "map.png"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["a"], "a.png");
  EXPECT_EQ(json["b"], "b.png");
  EXPECT_EQ(json["layer"], "");
  EXPECT_EQ(json["size"], nlohmann::json::array({16, 12}));
  EXPECT_NEAR(json["rmse"].get<double>(), 0.2, 1e-6);
  EXPECT_NEAR(json["psnr"].get<double>(), 13.9794, 1e-4);  // 20 log10(5)
  EXPECT_NEAR(json["bias"].get<double>(), 0.51, 1e-6);
  EXPECT_NEAR(json["scale"].get<double>(), 100.0 / 151.0, 1e-6);
  EXPECT_NEAR(json["rmse_scaled"].get<double>(), 0.0, 1e-6);
  EXPECT_NEAR(json["rel_mse"].get<double>(), 0.51 * 0.51 / 1.01, 1e-6);
  for (const char* key : {"flip", "ssim"}) {
    EXPECT_GT(json[key].get<double>(), 0.1) << key;
    EXPECT_LT(json[key].get<double>(), 1.0) << key;
  }
  const auto map = read_png(folder_ / "map.png");
  ASSERT_TRUE(map.ok()) << map.error().message;
  EXPECT_EQ(map->width, 16u);
  EXPECT_EQ(map->height, 12u);

  const Ended text = run({"diff", "a.png", "b.png", "--metric", "bias", "--metric", "rmse"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(line_count(text.out), 3u) << text.out;
  EXPECT_NE(text.out.find("0.51"), std::string::npos) << text.out;
}

TEST_F(Cli, DiffOfLayers) {
  write_light_exr(folder_ / "a.exr", 3.0f, 10.0f);
  write_light_exr(folder_ / "b.exr", 2.0f);
  const auto report = [&](const Arguments& more) {
    Arguments arguments = {"diff", "a.exr", "b.exr", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out, nullptr, false);
  };
  // Light of 30 and 3 against 2 everywhere.
  EXPECT_NEAR(report({})["bias"].get<double>(), 7.25, 1e-6);
  EXPECT_NEAR(report({"--mask-layer", "depth"})["bias"].get<double>(), 0.5, 1e-6);
  const auto indirect = report({"--layer", "indirect", "--mask-layer", "depth"});
  EXPECT_NEAR(indirect["rmse"].get<double>(), 0.5, 1e-6);
  EXPECT_EQ(indirect["layer"], "indirect");
  EXPECT_EQ(report({"--metric", "bias", "-o", "map.png", "--map", "relative"}).size(), 5u);
  const auto map = read_png(folder_ / "map.png");
  ASSERT_TRUE(map.ok()) << map.error().message;
  EXPECT_GT(map->samples[0], map->samples[4 * 15]);  // lighter at the left, where the error is
}

TEST_F(Cli, DiffOfEqualPictures) {
  write_light_exr(folder_ / "a.exr", 3.0f);
  const Ended ended = run({"diff", "a.exr", "a.exr", "--json", "--fail-above", "0"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  EXPECT_EQ(json["flip"], 0.0);
  EXPECT_TRUE(json["psnr"].is_null());  // infinite
}

TEST_F(Cli, DiffFailsAboveItsLimit) {
  write_grey_png(folder_ / "dark.png", 100);
  write_grey_png(folder_ / "bright.png", 151);
  const auto code = [&](const char* metric, const char* limit, bool swapped = false) {
    const Ended ended =
        run({"diff", swapped ? "dark.png" : "bright.png", swapped ? "bright.png" : "dark.png",
             "--metric", metric, "--fail-above", limit});
    EXPECT_EQ(line_count(ended.err), ended.code == 0 ? 0u : 1u) << ended.err;
    EXPECT_EQ(line_count(ended.out), 2u);  // the measure is shown either way
    return ended.code;
  };
  EXPECT_EQ(code("rmse", "0.21"), 0);
  EXPECT_EQ(code("rmse", "0.19"), 1);
  EXPECT_EQ(code("bias", "0.52"), 0);
  EXPECT_EQ(code("bias", "0.3"), 1);
  EXPECT_EQ(code("bias", "0.3", true), 1);  // 34 % too dark
  EXPECT_EQ(run({"diff", "dark.png", "bright.png", "--fail-above", "0.01"}).code, 1);  // flip
}

TEST_F(Cli, DiffOfWhatCannotBeCompared) {
  write_grey_png(folder_ / "a.png", 100);
  write_light_exr(folder_ / "a.exr", 1.0f);
  ASSERT_TRUE(write_png(folder_ / "small.png", {1, 1, 3, {0, 0, 0}}).ok());
  write_light_exr(folder_ / "nan.exr", std::numeric_limits<float>::quiet_NaN());
  ASSERT_TRUE(write_file(folder_ / "noise.png", "no picture").ok());
  const size_t files = file_count();

  expect_error(2, {"diff", "a.png"}, "B");
  expect_error(2, {"diff", "a.png", "a.exr"}, "a.exr");
  expect_error(2, {"diff", "a.jpg", "a.jpg"}, "a.jpg");
  const std::pair<const char*, const char*> of_png[] = {
      {"--layer", "indirect"}, {"--mask-layer", "depth"}, {"--metric", "beauty"},
      {"--fail-above", "-1"},  {"--fail-above", "nan"},   {"--fail-above", "much"},
      {"-o", "map.exr"},       {"--map", "flip"}};
  for (const auto& [flag, value] : of_png)
    expect_error(2, {"diff", "a.png", "a.png", flag, value}, flag);
  expect_error(2, {"diff", "a.png", "a.png", "-o", "map.png", "--map", "bump"}, "--map");
  expect_error(2, {"diff", "a.png", "a.png", "--metric", "ssim", "--fail-above", "1"}, "ssim");
  expect_error(
      2, {"diff", "a.png", "a.png", "--metric", "flip", "--metric", "rmse", "--fail-above", "1"},
      "--metric");

  expect_error(3, {"diff", "a.png", "missing.png"}, "missing.png");
  expect_error(3, {"diff", "a.png", "noise.png", "-o", "map.png"}, "noise.png");
  expect_error(3, {"diff", "a.png", "small.png"}, "1x1");
  expect_error(3, {"diff", "a.exr", "a.exr", "--layer", "albedo"}, "albedo");
  expect_error(3, {"diff", "a.exr", "a.exr", "--mask-layer", "normal"}, "normal");
  expect_error(3, {"diff", "a.exr", "nan.exr", "-o", "map.png"}, "nan.exr");
  expect_error(3, {"diff", "a.exr", "nan.exr"}, "192 of 192 pixels");
  expect_error(4, {"diff", "a.png", "a.png", "-o", "missing/map.png"}, "missing");
  EXPECT_EQ(file_count(), files);
}

}  // namespace
}  // namespace lueur
