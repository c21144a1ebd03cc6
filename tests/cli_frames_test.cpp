// SPDX-License-Identifier: MIT
// lueur render --frames as a user and a script meet it.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "image/exr.h"
#include "image/png.h"
#include "support/cli.h"

namespace lueur {
namespace {

class CliFrames : public Cli {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_))
      all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
  }
  std::string content(const char* name) const { return text_of(folder_ / name); }
};

TEST_F(CliFrames, WritesAllOfThem) {
  const Ended ended = render({"--frames", "8-10", "--fps", "5", "--time", "1", "--seed", "3", "-o",
                              "{frame:4}.png", "-o", "light.{frame}.exr", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(names(), (std::vector<std::string>{"0008.png", "0009.png", "0010.png", "light.10.exr",
                                               "light.8.exr", "light.9.exr"}));
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["frames"], 3);
  EXPECT_EQ(json["first_frame"], 8);
  EXPECT_EQ(json["last_frame"], 10);
  EXPECT_EQ(json["fps"], 5);
  EXPECT_EQ(json["outputs"].size(), 6u);
  EXPECT_GT(json["technique_ms"].get<double>(), 0.0);
  EXPECT_GT(json["frame_ms"].get<double>(), json["technique_ms"].get<double>());
  EXPECT_EQ(json["passes"][0]["name"], "renderer.g_buffer");

  ExrAttributes attributes;
  ASSERT_TRUE(read_exr(folder_ / "light.9.exr", &attributes).ok());
  EXPECT_EQ(attributes["lueur.seed"], "12");
  EXPECT_FLOAT_EQ(std::stof(attributes["lueur.time_s"]), 1.0f + 9.0f / 5.0f);
}

// A technique without a memory gives each frame as if it were alone; one with a memory does not.
TEST_F(CliFrames, AreThePicturesOfTheirTimes) {
  const auto picture = [&](const char* temporal, const Arguments& more) {
    Arguments arguments = {"--set", std::string("temporal=") + temporal, "--exposure", "-4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = render(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
  };
  picture("0", {"--frames", "0-2", "--fps", "4", "-o", "{frame}.png"});
  picture("0", {"--time", "0.5", "--seed", "2", "-o", "alone.png"});
  picture("0", {"--frames", "2", "--fps", "4", "--settle", "3", "-o", "settled{frame}.png"});
  EXPECT_FALSE(content("2.png").empty());
  EXPECT_TRUE(content("2.png") == content("alone.png"));
  EXPECT_TRUE(content("2.png") == content("settled2.png"));
  EXPECT_FALSE(content("2.png") == content("1.png"));
  EXPECT_EQ(file_count(), 5u);

  picture("0.9", {"--frames", "0-2", "--fps", "4", "-o", "memory{frame}.png"});
  picture("0.9", {"--frames", "2", "--fps", "4", "-o", "alone{frame}.png"});
  picture("0.9", {"--frames", "2", "--fps", "4", "--settle", "2", "-o", "settled{frame}.png"});
  EXPECT_FALSE(content("memory2.png") == content("alone2.png"));
  EXPECT_TRUE(content("memory2.png") == content("settled2.png"));
}

// The first frame is metered, also when it is not frame 0, and the others are shown alike.
TEST_F(CliFrames, KeepTheExposureOfTheFirst) {
  const auto exposure = [&](const Arguments& more) {
    Arguments arguments = {"render", "spot-floor",  "--size", "64x36", "--exposure",
                           "auto",   "--technique", "none",   "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out)["exposure_ev"].get<float>();
  };
  const float both = exposure({"--frames", "2-5", "--fps", "1", "-o", "{frame}.exr"});
  EXPECT_EQ(both, exposure({"--time", "2"}));
  EXPECT_NE(both, exposure({"--time", "5"}));
  for (const char* name : {"2.exr", "5.exr"}) {
    ExrAttributes attributes;
    ASSERT_TRUE(read_exr(folder_ / name, &attributes).ok());
    EXPECT_NEAR(std::stof(attributes["lueur.exposure_ev"]), both, 1e-5f) << name;
  }
}

TEST_F(CliFrames, ShowAViewAndAreScanned) {
  const Ended ended = render({"--frames", "0-1", "--view", "hierarchical.gather@0.indirect", "-o",
                              "{frame}.png", "--scan", "--validate"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const auto view = read_png(folder_ / "1.png");
  ASSERT_TRUE(view.ok());
  EXPECT_EQ(view->width, 32u);
}

TEST_F(CliFrames, UsageErrors) {
  const auto expect_fails = [&](const Arguments& more, const std::string& part, int code = 2) {
    Arguments arguments = {"render", "cornell", "--size", "8x8"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_error(code, arguments, part);
  };
  for (const char* range : {"3-1", "x", "-1", "0-1-2", "0-1000000"})
    expect_fails({"--frames=" + std::string(range), "-o", "{frame}.png"}, "--frames");
  expect_fails({"--frames", "0-60001", "-o", "{frame}.png"}, "1000 seconds");
  expect_fails({"--frames", "0-1", "--fps", "0", "-o", "{frame}.png"}, "--fps");
  expect_fails({"--frames", "0-1", "--settle", "-1", "-o", "{frame}.png"}, "--settle");
  expect_fails({"--settle", "1", "-o", "a.png"}, "--frames");
  expect_fails({"--frames", "0-1"}, "-o");
  expect_fails({"--frames", "0-1", "-o", "a.png"}, "a.{frame:4}.png");
  expect_fails({"--frames", "0-1", "-o", "{frame:0}.png"}, "{frame:N}");
  expect_fails({"--frames", "0-1", "-o", "{frame}/a.png"}, "folder");
  expect_fails({"--frames", "0-1", "-o", "{frame}.jpg"}, ".png");
  expect_fails({"--frames", "0-1", "-o", "{frame}.png", "-o", "{frame}.png"}, "{frame}.png");
  expect_fails({"--frames", "0-1", "--list-views"}, "--list-views");
  expect_fails({"--frames", "0-1", "--dump", "*", "--dump-to", "passes"}, "--dump");
  expect_fails({"--frames", "0-1", "--view", "no.image", "-o", "{frame}.png"}, "no.image");
  expect_fails({"-o", "{frame:4}.png"}, "--frames");
  expect_fails({"--frames", "0-1", "-o", "missing/{frame}.png"}, "missing", 4);
  expect_fails({"--frames", "0-1", "-o", "/proc/{frame}.png"}, "/proc", 4);
  EXPECT_EQ(file_count(), 0u);
}

// A disk that is full from the third frame on.
TEST_F(CliFrames, FullDiskEndsThem) {
  fs::create_symlink("/dev/full", folder_ / "2.png");
  expect_error(4, {"render", "cornell", "--size", "8x8", "--frames", "0-4", "-o", "{frame}.png"},
               "2.png");
  EXPECT_EQ(names(), (std::vector<std::string>{"0.png", "1.png", "2.png"}));
}

TEST_F(CliFrames, InterruptedTheyAreWhole) {
  const pid_t child = start(LUEUR_PROGRAM, {"render", "cornell", "--size", "64x36", "--frames",
                                            "0-50000", "-o", "{frame:5}.png"});
  for (int k = 0; k < 1000 && !fs::exists(folder_ / "00001.png"); ++k) ::usleep(20'000);
  ASSERT_EQ(::kill(child, SIGINT), 0);
  const Ended ended = end(child);
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
  const size_t written = file_count();
  EXPECT_GE(written, 2u);
  EXPECT_NE(ended.err.find(" " + std::to_string(written) + " of 50001 frames"), std::string::npos)
      << ended.err;
  for (const std::string& name : names()) EXPECT_TRUE(read_png(folder_ / name).ok()) << name;
}

// Skins, morph targets and nodes of files made by others: each frame differs from the one before,
// and says that something moved.
TEST_F(CliFrames, FilesMove) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  for (const char* file :
       {"khronos_samples_2018/CesiumMan/glTF-Binary/CesiumMan.glb",
        "khronos_samples_2018/AnimatedMorphCube/glTF-Binary/AnimatedMorphCube.glb",
        "khronos_samples_2018/AnimatedTriangle/glTF/AnimatedTriangle.gltf",
        "khronos_extra/bevy/Fox.glb"}) {
    const Ended ended = run({"render", std::string(data) + "/" + file, "--size", "64x48",
                             "--frames", "1-3", "--fps", "10", "-o", "{frame}.exr"});
    ASSERT_EQ(ended.code, 0) << file << ": " << ended.err;
    std::vector<float> before;
    for (const char* name : {"1.exr", "2.exr", "3.exr"}) {
      const auto layers = read_exr(folder_ / name);
      ASSERT_TRUE(layers.ok()) << layers.error().message;
      EXPECT_NE(layers->front().image.samples, before) << file << " " << name;
      before = layers->front().image.samples;
      for (const ImageLayer& layer : *layers)
        if (layer.name == "motion") {
          EXPECT_GT(std::count_if(layer.image.samples.begin(), layer.image.samples.end(),
                                  [](float shift) { return shift != 0.0f; }),
                    20)
              << file << " " << name;
        }
    }
  }
}

}  // namespace
}  // namespace lueur
