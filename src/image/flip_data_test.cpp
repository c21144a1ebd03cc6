// SPDX-License-Identifier: MIT
// FLIP against figures of NVIDIA's own tool, where the data is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "image/color_map.h"
#include "image/flip.h"
#include "image/picture_error.h"
#include "image/png.h"
#include "image/tone_map.h"

namespace lueur {
namespace {

namespace fs = std::filesystem;

class FlipData : public testing::Test {
 protected:
  void SetUp() override {
    const char* data = std::getenv("LUEUR_DATA");
    if (data == nullptr) GTEST_SKIP() << "LUEUR_DATA does not name the test data";
    folder_ = fs::path(data) / "flip";
    std::ifstream file(folder_ / "EXPECTED.json");
    expected_ = nlohmann::json::parse(file, nullptr, false);
    ASSERT_TRUE(expected_.is_object()) << folder_ << " has no EXPECTED.json";
  }

  Image8 picture(const std::string& name) const {
    auto image = read_png(folder_ / name);
    EXPECT_TRUE(image.ok()) << image.error().message;
    return image.ok() ? std::move(*image) : Image8{};
  }

  fs::path folder_;
  nlohmann::json expected_;
};

ImageF linear(const Image8& image) {
  ImageF result(image.width, image.height, image.channels);
  for (size_t i = 0; i < result.samples.size(); ++i)
    result.samples[i] = linear_from_srgb(static_cast<float>(image.samples[i]) / 255.0f);
  return result;
}

// The value below which a share of the sum of all values lies, as the tool computes it.
double weighted_quantile(std::vector<float> values, double share) {
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value);
  double running = 0.0;
  for (const float value : values) {
    running += static_cast<double>(value);
    if (running > share * sum) return static_cast<double>(value);
  }
  return 0.0;
}

// The tool computes in single precision and prints six digits.
constexpr double kMeanBound = 1e-5;
constexpr double kQuantileBound = 1e-4;  // one pixel more or less below it

TEST_F(FlipData, ReproducesPublishedFigures) {
  size_t compared = 0;
  for (const auto& entry : expected_["ldr"]) {
    const ImageF test = linear(picture(entry["test"]));
    const ImageF reference = linear(picture(entry["ref"]));
    const ImageF map = flip_map(test, reference, entry.value("ppd", kFlipPixelsPerDegree));
    EXPECT_NEAR(mean(map, nullptr), entry["mean"].get<double>(), kMeanBound) << entry;
    ++compared;
    const auto expect = [&](const char* key, double value) {
      if (entry.contains(key)) {
        EXPECT_NEAR(value, entry[key].get<double>(), kQuantileBound) << key;
      }
    };
    expect("weighted_median", weighted_quantile(map.samples, 0.5));
    expect("q1", weighted_quantile(map.samples, 0.25));
    expect("q3", weighted_quantile(map.samples, 0.75));
    const auto [least, most] = std::minmax_element(map.samples.begin(), map.samples.end());
    expect("min", static_cast<double>(*least));
    expect("max", static_cast<double>(*most));
  }
  EXPECT_GE(compared, 3u);
}

// The published map was made with another version of the tool: 3 code values.
TEST_F(FlipData, ReproducesThePublishedMap) {
  const auto errors = display_errors(picture("tree-test.png"), picture("tree-ref.png"));
  ASSERT_TRUE(errors.ok()) << errors.error().message;
  EXPECT_NEAR(errors->flip, expected_["ldr"][0]["mean"].get<double>(), kMeanBound);
  const Image8 ours = in_magma(errors->flip_map);
  const Image8 theirs = picture("tree-comparison-cli.png");
  ASSERT_EQ(ours.width, theirs.width);
  ASSERT_EQ(ours.height, theirs.height);
  int largest = 0;
  for (size_t i = 0; i < errors->flip_map.samples.size(); ++i)
    for (size_t c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(int{ours.samples[3 * i + c]} -
                                           int{theirs.samples[theirs.channels * i + c]}));
  EXPECT_LE(largest, 3);
}

}  // namespace
}  // namespace lueur
