// SPDX-License-Identifier: MIT
// lueur compare and lueur paper as a user and a script meet them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/cli.h"

namespace lueur {
namespace {

using Json = nlohmann::json;

class CliCompare : public Cli {
 protected:
  Ended compare(Arguments more) const {
    Arguments arguments = {"compare", "cornell",  "--size", "48x27", "--spp",
                           "32",      "--frames", "1",      "-o",    "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  static double error_of(const Json& entry, const char* reference, const char* metric) {
    return entry["errors"][reference][metric].get<double>();
  }
};

TEST_F(CliCompare, HoldsTechniquesAgainstReferences) {
  const Ended ended =
      compare({"--techniques", "hierarchical,hierarchical:start=full:samples=32,none",
               "--reference", "path,screen", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json printed = Json::parse(ended.out);
  EXPECT_EQ(printed, Json::parse(text_of(folder_ / "out/results.json")));
  EXPECT_EQ(file_count(), 1u);
  EXPECT_NE(text_of(folder_ / "out/index.html").find("<!DOCTYPE html>"), std::string::npos);
  EXPECT_EQ(line_count(text_of(folder_ / "out/results.csv")), 1u + 3 * 2);

  ASSERT_EQ(printed["entries"].size(), 3u);
  const Json &half = printed["entries"][0], &full = printed["entries"][1],
             &none = printed["entries"][2];
  EXPECT_EQ(half["label"], "hierarchical");
  EXPECT_EQ(full["settings"]["samples"], 32);
  EXPECT_GT(half["technique_ms"], 0.0);
  EXPECT_EQ(none["technique_ms"], 0.0);
  for (const char* reference : {"path", "screen"}) {
    // No indirect light at all is all of it too dark, and farther off than any estimate of it.
    EXPECT_NEAR(error_of(none, reference, "indirect_bias"), -1.0, 1e-6);
    for (const Json* entry : {&half, &full}) {
      EXPECT_LT(error_of(*entry, reference, "flip"), error_of(none, reference, "flip"));
      EXPECT_LT(error_of(*entry, reference, "rmse"), error_of(none, reference, "rmse"));
    }
  }
  EXPECT_EQ(printed["references"][1]["mode"], "screen");
  EXPECT_EQ(printed["references"][1]["samples_per_pixel"], 32);
  EXPECT_NE(printed["command"].get<std::string>().find("--reference path,screen"),
            std::string::npos);
}

TEST_F(CliCompare, WorksWithoutTheTruth) {
  const Ended ended = compare({"--techniques", "none", "--reference", "", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  // The command that reproduces it says so, as path is what is compared by default.
  const Json printed = Json::parse(ended.out);
  EXPECT_NE(printed["command"].get<std::string>().find("--reference ''"), std::string::npos);
  EXPECT_EQ(line_count(text_of(folder_ / "out/results.csv")), 2u);
}

TEST_F(CliCompare, UsageErrors) {
  const auto expect_fails = [&](const Arguments& more, const std::string& part) {
    Arguments arguments = {"compare", "cornell", "--size", "8x8", "-o", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_error(2, arguments, part);
  };
  expect_error(2, {"compare", "cornell"}, "--output");
  expect_fails({"--techniques", "magic"}, "magic");
  expect_fails({"--techniques", "none,none"}, "twice");
  expect_fails({"--techniques", "hierarchical:samples=0"}, "samples");
  expect_fails({"--reference", "ambient"}, "ambient");
  expect_fails({"--reference", "path,path"}, "twice");
  expect_fails({"--reference", "path:spp=0"}, "spp");
  expect_fails({"--reference", "path:light=1"}, "light");
  expect_fails({"--reference", "true"}, "screen-unoccluded");
  expect_fails({"--spp", "0"}, "--spp");
  expect_fails({"--bounces", "65"}, "--bounces");
  expect_fails({"--frames", "0"}, "--frames");
  expect_fails({"--camera", "99"}, "--camera");
  EXPECT_FALSE(fs::exists(folder_ / "out/index.html"));
}

TEST_F(CliCompare, FolderThatCannotBe) {
  expect_error(4, {"compare", "cornell", "--size", "8x8", "-o", "/proc/out"}, "/proc/out");
}

TEST_F(CliCompare, PaperMakesItsFigures) {
  const Ended ended = run({"paper", "hssil", "--size", "64x36", "--picture-size", "64x36", "--spp",
                           "16", "--frames", "1", "--json", "-o", "out"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json printed = Json::parse(ended.out);
  EXPECT_EQ(printed, Json::parse(text_of(folder_ / "out/figures.json")));
  ASSERT_EQ(printed["sections"].size(), 3u);
  EXPECT_EQ(file_count(), 1u);
  EXPECT_TRUE(fs::exists(folder_ / "out/index.html"));
  // The first table of figure 4: what the levels give adds up to all of it.
  double shares = 0;
  for (const Json& block : printed["sections"][0]["blocks"])
    if (block["kind"] == "table")
      for (const Json& row : block["rows"]) shares += row[2].get<double>();
  EXPECT_NEAR(shares, 1.0, 0.01);
}

TEST_F(CliCompare, PaperUsageErrors) {
  expect_error(2, {"paper"}, "NAME");
  expect_error(2, {"paper", "siggraph"}, "hssil");
  expect_error(2, {"paper", "hssil", "--figures", "9"}, "4, 5, 6");
  expect_error(2, {"paper", "hssil", "--frames", "0"}, "--frames");
  expect_error(2, {"paper", "hssil", "--size", "8"}, "--size");
}

}  // namespace
}  // namespace lueur
