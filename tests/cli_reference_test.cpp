// SPDX-License-Identifier: MIT
// lueur reference as a user and a script meet it.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "base/file.h"
#include "image/exr.h"
#include "image/png.h"
#include "support/cli.h"

namespace lueur {
namespace {

class CliReference : public Cli {
 protected:
  Ended reference(Arguments more) const {
    Arguments arguments = {"reference", "cornell", "--size", "32x18"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  // Starts `lueur reference` on more than it can ever finish, and waits until it traces: from then
  // on it blocks SIGINT, which is in its status.
  pid_t start_endless_reference(const std::string& output) const {
    const pid_t child = start(LUEUR_PROGRAM, {"reference", "cornell", "--size", "32x18", "--spp",
                                              "1048576", "--no-cache", "-o", output});
    constexpr uint64_t kInterrupt = 1u << (SIGINT - 1);
    const std::string status = "/proc/" + std::to_string(child) + "/status";
    for (int k = 0; k < 1000; ++k) {
      std::ifstream file(status);
      for (std::string line; std::getline(file, line);)
        if (line.starts_with("SigBlk:") &&
            (std::stoull(line.substr(7), nullptr, 16) & kInterrupt)) {
          // Long enough for some passes, of 2 ms each.
          ::usleep(200'000);
          return child;
        }
      ::usleep(20'000);
    }
    ADD_FAILURE() << "it does not begin";
    return child;
  }
};

// The layers of two EXR files are the same, bit for bit.
void expect_same_layers(const fs::path& a, const fs::path& b) {
  const auto first = read_exr(a), second = read_exr(b);
  ASSERT_TRUE(first.ok()) << first.error().message;
  ASSERT_TRUE(second.ok()) << second.error().message;
  ASSERT_EQ(first->size(), second->size());
  for (size_t k = 0; k < first->size(); ++k) {
    EXPECT_EQ((*first)[k].name, (*second)[k].name);
    EXPECT_TRUE((*first)[k].image.samples == (*second)[k].image.samples) << (*first)[k].name;
  }
}

TEST_F(CliReference, WritesItsLayers) {
  for (const auto& [mode, present, absent] : {std::tuple("path", "indirect_specular", "occlusion"),
                                              {"screen", "indirect", "occlusion"},
                                              {"screen-unoccluded", "indirect", "variance"},
                                              {"ambient", "occlusion", "indirect"}}) {
    const Ended ended =
        reference({"--mode", mode, "--spp", "8", "-o", "a.exr", "-o", "a.png", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    const auto json = nlohmann::json::parse(ended.out, nullptr, false);
    ASSERT_TRUE(json.is_object());
    EXPECT_EQ(json["mode"], mode);
    EXPECT_EQ(json["complete"], true);
    EXPECT_EQ(json["size"], nlohmann::json::array({32, 18}));
    EXPECT_EQ(json["outputs"], nlohmann::json::array({"a.exr", "a.png"}));
    EXPECT_TRUE(read_png(folder_ / "a.png").ok());
    ExrAttributes attributes;
    const auto layers = read_exr(folder_ / "a.exr", &attributes);
    ASSERT_TRUE(layers.ok()) << layers.error().message;
    EXPECT_EQ(attributes["lueur.reference.mode"], mode);
    EXPECT_EQ(attributes["lueur.scene"], "cornell");
    bool has_present = false;
    for (const ImageLayer& layer : *layers) {
      EXPECT_NE(layer.name, absent) << mode;
      has_present = has_present || layer.name == present;
    }
    EXPECT_TRUE(has_present) << mode;
  }
  EXPECT_EQ(file_count(), 2u);
}

TEST_F(CliReference, UsageErrors) {
  expect_error(2, {"reference"}, "SCENE");
  expect_error(2, {"reference", "cornell"}, "-o");
  expect_error(2, {"reference", "cornel", "-o", "x.exr"}, "cornell");
  expect_error(2, {"reference", "cornell", "-o", "x.tif"}, ".exr");
  for (const char* mode : {"magic", "Path", "screen_unoccluded", ""})
    expect_error(2, {"reference", "cornell", "-o", "x.exr", "--mode", mode}, "screen-unoccluded");
  const std::pair<const char*, const char*> values[] = {
      {"--spp", "0"},        {"--spp", "1048577"},
      {"--spp", "many"},     {"--bounces", "0"},
      {"--bounces", "65"},   {"--error", "0"},
      {"--error", "2"},      {"--error", "-0.1"},
      {"--error", "nan"},    {"--size", "0x9"},
      {"--camera", "99"},    {"--time", "inf"},
      {"--seed", "-1"},      {"--distance", "0"},
      {"--distance", "nan"}, {"--form-factor", "square"},
      {"--threads", "many"}, {"--exposure", "dark"},
      {"--tone-map", "no"},  {"--frobnicate", "1"}};
  for (const auto& [flag, value] : values)
    expect_error(2, {"reference", "cornell", "-o", "x.exr", "--size", "8x8", flag, value}, flag);
  // Of screen-unoccluded 0 is a number: all pixels.
  EXPECT_EQ(reference({"--mode", "screen-unoccluded", "--spp", "0", "-o", "y.exr"}).code, 0);
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(CliReference, FileErrors) {
  const auto expect_fails = [&](int code, Arguments more, const std::string& part) {
    Arguments arguments = {"reference", "cornell", "--size", "8x8", "--spp", "8"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_error(code, arguments, part);
  };
  expect_fails(4, {"-o", "missing/x.exr"}, "missing");
  expect_fails(4, {"-o", "/proc/x.exr"}, "/proc/x.exr");
  expect_fails(3, {"-o", "x.exr", "--no-cache", "--resume"}, "x.exr.resume: no such file; start");
  ASSERT_TRUE(write_file(folder_ / "x.exr.resume", "nonsense").ok());
  expect_fails(3, {"-o", "x.exr", "--no-cache", "--resume"}, "x.exr.resume");
  expect_error(3, {"reference", "missing.glb", "-o", "x.exr"}, "missing.glb");
  EXPECT_FALSE(fs::exists(folder_ / "x.exr"));
}

TEST_F(CliReference, ComesFromTheCache) {
  const auto from_cache = [&](const Arguments& more) {
    Arguments arguments = {"--spp", "16", "--seed", "77", "--json", "-o", "a.exr"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = reference(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out)["from_cache"].get<bool>();
  };
  EXPECT_FALSE(from_cache({"--no-cache"}));
  fs::rename(folder_ / "a.exr", folder_ / "b.exr");
  EXPECT_FALSE(from_cache({}));
  EXPECT_TRUE(from_cache({}));
  expect_same_layers(folder_ / "a.exr", folder_ / "b.exr");
}

TEST_F(CliReference, GoesOnAfterAnInterrupt) {
  const pid_t child = start_endless_reference("a.exr");
  ASSERT_EQ(::kill(child, SIGINT), 0);
  const Ended ended = end(child);
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
  EXPECT_NE(ended.err.find("--resume"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::exists(folder_ / "a.exr.resume"));
  ExrAttributes attributes;
  ASSERT_TRUE(read_exr(folder_ / "a.exr", &attributes).ok());
  EXPECT_EQ(attributes["lueur.reference.complete"], "0");
  const uint32_t done = static_cast<uint32_t>(std::stoul(attributes["lueur.reference.spp"]));
  EXPECT_GT(done, 0u);

  // Another scene's state is refused and stays.
  expect_error(
      3, {"reference", "cornell", "--size", "32x18", "--seed", "1", "-o", "a.exr", "--resume"},
      "a.exr.resume");
  EXPECT_TRUE(fs::exists(folder_ / "a.exr.resume"));

  const std::string spp = std::to_string(done + 64);
  const Ended more = reference({"--spp", spp, "--no-cache", "--resume", "-o", "a.exr"});
  EXPECT_EQ(more.code, 0) << more.err;
  EXPECT_FALSE(fs::exists(folder_ / "a.exr.resume"));
  EXPECT_EQ(reference({"--spp", spp, "--no-cache", "-o", "b.exr"}).code, 0);
  expect_same_layers(folder_ / "a.exr", folder_ / "b.exr");
}

TEST_F(CliReference, KilledLeavesNothingHalf) {
  ASSERT_TRUE(write_file(folder_ / "old.exr", "what was there before").ok());
  for (const char* output : {"new.exr", "old.exr"}) {
    const pid_t child = start_endless_reference(output);
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    EXPECT_EQ(end(child).code, -1);
  }
  EXPECT_FALSE(fs::exists(folder_ / "new.exr"));
  EXPECT_EQ(text_of(folder_ / "old.exr"), "what was there before");
}

}  // namespace
}  // namespace lueur
