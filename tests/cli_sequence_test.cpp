// SPDX-License-Identifier: MIT
// lueur sequence as a user and a script meet it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "image/png.h"
#include "support/cli.h"

namespace lueur {
namespace {

using Json = nlohmann::json;

class CliSequence : public Cli {
 protected:
  // At a million frames a second nothing moves by a thousandth of a pixel.
  static Arguments standing() { return {"--rate", "1000000"}; }

  // The rows of the techniques in `list`. None has a memory that would have to settle.
  Json measure(const std::string& list, const Arguments& more = {},
               const char* frames = "4") const {
    Arguments arguments = {"sequence",     "cornell",  "--size", "48x27",     "--frames",
                           frames,         "--settle", "0",      "--average", "4",
                           "--techniques", list,       "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.code == 0 ? Json::parse(ended.out)["techniques"] : Json();
  }
  static double value(const Json& row, const char* key) { return row[key].get<double>(); }
};

// The same picture four times does not flicker, up to the rounding of a camera that moves by a
// millionth of its way. Another pattern of 4 samples a pixel in each frame does.
TEST_F(CliSequence, FlickerIsThePattern) {
  Arguments fixed = standing();
  fixed.emplace_back("--fixed-seed");
  const Json quiet = measure("hierarchical:samples=4", fixed);
  const Json counted = measure("hierarchical:samples=4", standing());
  ASSERT_EQ(quiet.size() + counted.size(), 2u);
  EXPECT_LT(value(quiet[0], "flicker"), 1e-3);
  EXPECT_GT(value(counted[0], "flicker"), 0.1);
  // All instants share their seeds.
  EXPECT_LT(value(counted[0], "reference_flicker"), 1e-3);
  EXPECT_NEAR(value(counted[0], "excess"),
              value(counted[0], "flicker") - value(counted[0], "reference_flicker"), 1e-12);
}

TEST_F(CliSequence, FewSamplesFlickerMore) {
  const Json rows = measure("hierarchical:samples=4,hierarchical:samples=64,none", {"--from", "2"});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0]["label"], "hierarchical:samples=4");
  EXPECT_EQ(rows[0]["technique"], "hierarchical");
  EXPECT_EQ(rows[0]["settings"]["samples"], 4);
  EXPECT_GT(value(rows[0], "flicker"), value(rows[1], "flicker"));
  EXPECT_GT(value(rows[0], "excess"), value(rows[1], "excess"));
  // Both converge to light that moves about alike.
  EXPECT_GT(value(rows[1], "reference_flicker"), 0.0);
  for (const char* key : {"flicker", "reference_flicker", "excess", "ghost_bias", "ghost_error"})
    EXPECT_EQ(value(rows[2], key), 0.0) << key;
}

// Without a memory, what was uncovered is as noisy as all else. Two independent estimates differ by
// sqrt(2) of the error of one, so that the error should be about 0.7 of the flicker of a standing
// picture; the bounds leave a factor of 2, as the noise is not the same everywhere.
TEST_F(CliSequence, GhostsOfNoMemoryAreNoise) {
  const char* list = "hierarchical:samples=256:temporal=0";
  const Json moving = measure(list, {"--rate", "5"}, "8");
  const Json still = measure(list, standing(), "8");
  ASSERT_EQ(moving.size() + still.size(), 2u);
  EXPECT_GT(moving[0]["ghost_pixels"], 100);
  EXPECT_EQ(still[0]["ghost_pixels"], 0);
  const double noise = std::sqrt(0.5) * value(still[0], "flicker");
  EXPECT_GT(value(moving[0], "ghost_error"), noise / 2.0);
  EXPECT_LT(value(moving[0], "ghost_error"), noise * 2.0);
  EXPECT_LT(std::abs(value(moving[0], "ghost_bias")), noise);
}

TEST_F(CliSequence, HoldsTheCameraOrTheScene) {
  const auto pixels = [&](const Arguments& hold) {
    Arguments more = {"--rate", "5"};
    more.insert(more.end(), hold.begin(), hold.end());
    return measure("none", more)[0]["ghost_pixels"].get<int>();
  };
  // Only the lamp of this scene moves by itself: it uncovers less than the camera that goes around.
  EXPECT_LT(pixels({"--hold", "camera"}), pixels({"--hold", "scene"}));
}

TEST_F(CliSequence, WritesItsFrames) {
  const Ended ended =
      run({"sequence", "cornell", "--size", "48x27", "--frames", "2", "--average", "1", "--rate",
           "2", "--techniques", "hierarchical:samples=4,none", "-o", "out"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(line_count(ended.out), 4u) << ended.out;  // two lines of heading, two rows
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_ / "out"))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"hierarchical_samples=4-0000.png",
                                             "hierarchical_samples=4-0001.png", "none-0000.png",
                                             "none-0001.png"}));
  const auto first = read_png(folder_ / "out/none-0000.png");
  const auto second = read_png(folder_ / "out/none-0001.png");
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(first->width, 48u);
  EXPECT_EQ(first->height, 27u);
  EXPECT_NE(first->samples, second->samples);
}

TEST_F(CliSequence, UsageErrors) {
  const auto expect_fails = [&](const Arguments& more, const std::string& part) {
    Arguments arguments = {"sequence", "cornell", "--size", "8x8"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_error(2, arguments, part);
  };
  expect_error(2, {"sequence"}, "SCENE");
  expect_error(2, {"sequence", "atlantis"}, "atlantis");
  expect_fails({"--techniques", "magic"}, "magic");
  expect_fails({"--techniques", "none,none"}, "twice");
  expect_fails({"--techniques", "hierarchical:samples=0"}, "samples");
  expect_fails({"--from", "soon"}, "--from");
  expect_fails({"--rate", "0"}, "--rate");
  expect_fails({"--rate", "-60"}, "--rate");
  expect_fails({"--frames", "1"}, "--frames");
  expect_fails({"--settle", "-1"}, "--settle");
  expect_fails({"--average", "0"}, "--average");
  expect_fails({"--uncovered", "0"}, "--uncovered");
  expect_fails({"--hold", "breath"}, "--hold");
  expect_fails({"--seed", "x"}, "--seed");
  expect_fails({"--camera", "99"}, "--camera");
  expect_error(4, {"sequence", "cornell", "--size", "8x8", "-o", "/proc/out"}, "/proc/out");
}

}  // namespace
}  // namespace lueur
