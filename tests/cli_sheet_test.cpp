// SPDX-License-Identifier: MIT
// lueur scene sheet as a user and a script meet it.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "report/text.h"
#include "support/cli.h"

namespace lueur {
namespace {

using Json = nlohmann::json;

class CliSheet : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    fs::create_directories(folder_ / "models/rooms");
    ASSERT_TRUE(write_file(folder_ / "models/broken.glb", "glTF").ok());
  }

  static Arguments sheet_of(const Arguments& more) {
    Arguments arguments = {"scene", "sheet", "--size", "64x36", "-o", "sheet.html"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Json report(Arguments more) const {
    more.emplace_back("--json");
    const Ended ended = run(sheet_of(more));
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.code == 0 ? Json::parse(ended.out) : Json();
  }
  std::string page() const { return text_of(folder_ / "sheet.html"); }
};

TEST_F(CliSheet, DrawsScenesFilesAndFolders) {
  ASSERT_EQ(run({"scene", "export", "cornell", "-o", "models/rooms/box.glb"}).code, 0);
  const Json printed = report({"spot-floor", "models", "cornell"});
  EXPECT_EQ(printed["drawn"], 3);
  EXPECT_EQ(printed["refused"], 1);
  const Json& scenes = printed["scenes"];
  ASSERT_EQ(scenes.size(), 4u);
  EXPECT_EQ(scenes[0]["scene"], "spot-floor");
  EXPECT_EQ(scenes[1]["scene"], "models/broken.glb");
  EXPECT_EQ(scenes[1]["error"].get<std::string>().find("models/broken.glb: "), 0u);
  EXPECT_FALSE(scenes[1].contains("triangles"));
  EXPECT_EQ(scenes[2]["scene"], "models/rooms/box.glb");
  EXPECT_EQ(scenes[2]["name"], "box");
  EXPECT_EQ(scenes[2]["triangles"], scenes[3]["triangles"]);
  EXPECT_GT(scenes[2]["load_ms"], 0.0);
  EXPECT_EQ(scenes[3]["cameras"].size(), 1u);
  EXPECT_TRUE(scenes[3]["warnings"].is_array());
  EXPECT_NE(page().find("models/rooms/box.glb"), std::string::npos);
  EXPECT_NE(page().find("models/broken.glb"), std::string::npos);
}

// Whatever was drawn before, a picture is the very file that `lueur render` writes.
TEST_F(CliSheet, PicturesAreThoseOfRender) {
  ASSERT_EQ(run(sheet_of({"spot-floor", "cornell", "--set", "samples=8"})).code, 0);
  ASSERT_EQ(render({"--set", "samples=8", "-o", "cornell.png"}).code, 0);
  const std::string png = text_of(folder_ / "cornell.png");
  const auto* bytes = reinterpret_cast<const uint8_t*>(png.data());
  EXPECT_NE(page().find(report::base64({bytes, png.size()})), std::string::npos);
}

TEST_F(CliSheet, ShowsAllCameras) {
  const Json info = Json::parse(run({"scene", "info", "atrium", "--json"}).out);
  ASSERT_GT(info["cameras"].size(), 1u);
  const Json cameras = report(
      {"atrium:triangles=10000", "--all-cameras", "--technique", "none"})["scenes"][0]["cameras"];
  ASSERT_EQ(cameras.size(), info["cameras"].size());
  for (size_t i = 0; i < cameras.size(); ++i)
    EXPECT_EQ(cameras[i]["name"], info["cameras"][i]["name"]);
}

TEST_F(CliSheet, WhatIsRefusedIsCounted) {
  const Ended ended = run(sheet_of({"models", "cornell", "nowhere.glb", "cornel"}));
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out, "drawn: 1 scene\nnot drawn: 3\n");
  EXPECT_EQ(line_count(ended.err), 3u) << ended.err;
  for (const char* name : {"models/broken.glb: ", "nowhere.glb: ", "'cornel'"})
    EXPECT_NE(ended.err.find(name), std::string::npos) << name << " is not in " << ended.err;
}

TEST_F(CliSheet, NothingDrawnWritesNothing) {
  ASSERT_TRUE(write_file(folder_ / "sheet.html", "before").ok());
  expect_error(3, sheet_of({"models"}), "models/broken.glb");
  const Ended ended = run(sheet_of({"models", "nowhere.glb"}));
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(line_count(ended.err), 3u) << ended.err;
  EXPECT_NE(ended.err.find("none of 2 scenes"), std::string::npos) << ended.err;
  EXPECT_EQ(page(), "before");
}

TEST_F(CliSheet, MistakesAreOneLine) {
  expect_error(2, {"scene", "sheet", "cornell"}, "--output");
  expect_error(2, {"scene", "sheet", "cornell", "-o", "sheet.png"}, ".html");
  expect_error(4, {"scene", "sheet", "cornell", "-o", "missing/sheet.html"}, "missing");
  expect_error(3, sheet_of({"models/rooms"}), "models/rooms: ");
  const std::pair<const char*, const char*> values[] = {
      {"--size", "0x0"},  {"--size", "16384x16384"}, {"--time", "noon"},
      {"--device", "99"}, {"--technique", "magic"},  {"--set", "samples=0"}};
  for (const auto& [flag, value] : values)
    expect_error(2, sheet_of({"cornell", flag, value}), flag);
  EXPECT_FALSE(fs::exists(folder_ / "sheet.html"));
  fs::create_symlink("/dev/full", folder_ / "sheet.html");
  expect_error(4, sheet_of({"cornell"}), "sheet.html");
}

TEST_F(CliSheet, AnInterruptWritesNothing) {
  Arguments many = sheet_of({"models"});
  many.insert(many.end(), 100, "atrium");
  const pid_t child = start(LUEUR_PROGRAM, many);
  // The broken file's warning tells that drawing has begun.
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (text_of(folder_ / "stderr").empty() && std::chrono::steady_clock::now() < patience)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_EQ(::kill(child, SIGINT), 0);
  const Ended ended = end(child);
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_NE(ended.err.find("interrupted"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(folder_ / "sheet.html"));
}

}  // namespace
}  // namespace lueur
