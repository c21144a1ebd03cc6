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

// All is open without a technique: off by what the reference says is blocked. A technique without
// occlusion has nothing to hold against it.
TEST_F(CliCompare, HoldsOcclusionAgainstAmbient) {
  const Ended ended = compare({"--techniques", "none,hierarchical,hbao,visibility_bitmask",
                               "--reference", "ambient:distance=2,path", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json printed = Json::parse(ended.out);
  const char* ambient = "ambient:distance=2";
  const Json& none = printed["entries"][0];
  EXPECT_EQ(none["errors"][ambient].size(), 2u);
  EXPECT_GT(error_of(none, ambient, "occlusion_rmse"), 0.3);
  EXPECT_GT(error_of(none, ambient, "occlusion_bias"), 0.3);
  EXPECT_EQ(printed["entries"][1]["errors"].size(), 1u);
  for (const size_t i : {2, 3})
    EXPECT_LT(error_of(printed["entries"][i], ambient, "occlusion_rmse"),
              0.9 * error_of(none, ambient, "occlusion_rmse"));
  EXPECT_NE(text_of(folder_ / "out/index.html").find("occlusion_rmse"), std::string::npos);

  const Ended text = compare({"--techniques", "none", "--reference", "path,ambient"});
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(line_count(text.out), 4u) << text.out;
  EXPECT_NE(text.out.find("occlusion"), std::string::npos) << text.out;
}

// A technique's occlusion and the reference's lie in files under one name.
TEST_F(CliCompare, OcclusionIsALayer) {
  const Arguments common = {"cornell", "--size", "48x27", "-o"};
  const auto made = [&](Arguments first, const char* file, const Arguments& more) {
    first.insert(first.end(), common.begin(), common.end());
    first.push_back(file);
    first.insert(first.end(), more.begin(), more.end());
    const Ended ended = run(first);
    EXPECT_EQ(ended.code, 0) << ended.err;
  };
  made({"render"}, "hbao.exr", {"--technique", "hbao"});
  made({"render"}, "hbao.png", {"--technique", "hbao", "--view", "hbao.occlusion.occlusion"});
  made({"reference"}, "truth.exr", {"--mode", "ambient", "--spp", "32"});
  const auto rmse = [&](const Arguments& arguments) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return Json::parse(ended.out)["rmse"].get<double>();
  };
  const double of_layer = rmse(
      {"diff", "hbao.exr", "truth.exr", "--layer", "occlusion", "--mask-layer", "depth", "--json"});
  EXPECT_GT(of_layer, 0.001);
  EXPECT_LT(of_layer, 0.2);
  EXPECT_TRUE(fs::exists(folder_ / "hbao.png"));
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
  expect_fails({"--reference", "ambient:distance=0"}, "distance");
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

// The rows of the tables of a section, without their names.
std::vector<Json> rows_of(const Json& section) {
  std::vector<Json> rows;
  for (const Json& block : section["blocks"])
    if (block["kind"] == "table")
      rows.insert(rows.end(), block["rows"].begin(), block["rows"].end());
  return rows;
}

TEST_F(CliCompare, PaperOfTheDeferredPipeline) {
  const Ended ended = run({"paper", "fdp", "--size", "64x36", "--picture-size", "96x54", "--spp",
                           "16", "--frames", "1", "--json", "-o", "out"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json printed = Json::parse(ended.out);
  ASSERT_EQ(printed["sections"].size(), 6u);
  EXPECT_TRUE(fs::exists(folder_ / "out/index.html"));

  // Figure 2: equation (4) is less noisy than (3), and has no brighter spikes.
  const std::vector<Json> form_factors = rows_of(printed["sections"][0]);
  ASSERT_EQ(form_factors.size(), 2u);
  for (const size_t column : {1u, 2u})
    EXPECT_LT(form_factors[1][column].get<double>(), form_factors[0][column].get<double>());

  // Figure 3: so is the glossy floor with importance sampling.
  const std::vector<Json> glossy = rows_of(printed["sections"][1]);
  ASSERT_EQ(glossy.size(), 2u);
  for (const size_t column : {1u, 2u})
    EXPECT_LT(glossy[1][column].get<double>(), glossy[0][column].get<double>());

  // Figure 7: both ways to march, and rays, take some of the light, and not all.
  const std::vector<Json> visibility = rows_of(printed["sections"][3]);
  ASSERT_EQ(visibility.size(), 5u);
  for (const Json& row : visibility) {
    EXPECT_GT(row[1].get<double>(), 0.002) << row;
    EXPECT_LT(row[1].get<double>(), 0.9) << row;
  }
  // More steps find more of what stands between.
  EXPECT_GT(visibility[0][1].get<double>(), visibility[1][1].get<double>());

  // Figure 9: every cell that the paper has, ours has, too, but for the mipmaps, which it leaves
  // out; and the other way round.
  const std::vector<Json> costs = rows_of(printed["sections"][4]);
  ASSERT_GT(costs.size(), 18u);
  for (size_t i = 0; i < 19; ++i)
    for (size_t column = 1; column < costs[i].size(); column += 2)
      if (costs[i][0] == "mipmapping")
        EXPECT_GT(costs[i][column + 1].get<double>(), 0.0);
      else
        EXPECT_EQ(costs[i][column].is_null(), costs[i][column + 1].is_null()) << costs[i];
  EXPECT_EQ(costs[8][0], "all");
  EXPECT_EQ(costs[8][1], 1.0);
  EXPECT_EQ(costs[8][2], 1.0);

  // Figure 10: 256 samples are nearer to every pixel than 64.
  const std::vector<Json> starts = rows_of(printed["sections"][5]);
  ASSERT_EQ(starts.size(), 4u);
  for (const size_t first : {0u, 2u})
    EXPECT_LT(starts[first + 1][1].get<double>(), starts[first][1].get<double>());
}

TEST_F(CliCompare, PaperOfLightsHasItsTables) {
  const Ended ended = run(
      {"paper", "sol", "--size", "96x72", "--picture-size", "128x96", "--frames", "1", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json printed = Json::parse(ended.out);
  ASSERT_EQ(printed["sections"].size(), 3u);
  const std::vector<Json> lights = rows_of(printed["sections"][0]);
  ASSERT_EQ(lights.size(), 6u + 7u);
  const Json &fewest = lights[6], &most = lights[10], &many = lights[11], &exponents = lights[12];
  EXPECT_EQ(fewest[0], "30");
  EXPECT_EQ(most[0], "2000");
  // By scene: ours, and the sum with shadow rays. Both fall with the number of lights, ours to what
  // is left of very many lights where nothing is blocked.
  for (const size_t ours : {1u, 3u, 5u}) {
    EXPECT_LT(most[ours + 1].get<double>(), 0.5 * fewest[ours + 1].get<double>());
    EXPECT_LT(exponents[ours + 1].get<double>(), -0.2);
    EXPECT_NEAR(most[ours].get<double>() / many[ours].get<double>(), 1.0, 0.5);
  }
  // In the atrium much is blocked.
  EXPECT_GT(most[5].get<double>(), 3.0 * most[6].get<double>());
  // Low shares as asked for, and the fewer, the less is off.
  const std::vector<Json> shares = rows_of(printed["sections"][1]);
  ASSERT_EQ(shares.size(), 4u);
  EXPECT_GT(shares[0][2].get<double>(), 0.99);
  EXPECT_NEAR(shares[1][2].get<double>(), 0.875, 0.05);
  EXPECT_EQ(shares[3][2].get<double>(), 0.0);
  EXPECT_GT(shares[0][4].get<double>(), shares[1][4].get<double>());
  EXPECT_EQ(shares[3][4].get<double>(), 0.0);
  // With negative lights it is nearer to the sum with shadow rays.
  for (const Json& row : rows_of(printed["sections"][2]))
    EXPECT_LT(row[2].get<double>(), row[1].get<double>()) << row[0];
}

TEST_F(CliCompare, PaperOfCubeMapsHasItsTables) {
  const Ended ended = run({"paper", "lcm", "--figures", "6,cost", "--size", "64x36",
                           "--picture-size", "64x36", "--spp", "16", "--frames", "1", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json printed = Json::parse(ended.out);
  ASSERT_EQ(printed["sections"].size(), 2u);
  // Four places: off the full sum, off the truth; by one map in the room, by the object's own.
  const std::vector<Json> rows = rows_of(printed["sections"][0]);
  ASSERT_EQ(rows.size(), 16u);
  for (const size_t table : {0u, 8u}) {
    for (size_t place = 0; place < 4; ++place) {
      const Json& row = rows[table + place];
      const auto off = [&](size_t column) { return row[column].get<double>(); };
      EXPECT_LT(off(2), off(1)) << row;  // two texels a side are better than the classical map
      EXPECT_LT(off(4), off(2)) << row;
      EXPECT_LT(off(6), 12.0) << row;
    }
  }
  // What the object's own map gives is nearer to the truth than the classical map in the room.
  for (size_t place = 0; place < 4; ++place)
    EXPECT_LT(rows[12 + place][3].get<double>(), rows[4 + place][1].get<double>());
  EXPECT_EQ(rows_of(printed["sections"][1]).size(), 3u);
}

TEST_F(CliCompare, PaperUsageErrors) {
  expect_error(2, {"paper"}, "NAME");
  expect_error(2, {"paper", "siggraph"}, "fdp");
  expect_error(2, {"paper", "hssil", "--figures", "9"}, "4, 5, 6");
  expect_error(2, {"paper", "sol", "--figures", "9"}, "1, 2, 5");
  expect_error(2, {"paper", "lcm", "--figures", "9"}, "6, 7, cost");
  expect_error(2, {"paper", "fdp", "--figures", "2,5"}, "2, 3, 6, 7, 9, 10");
  expect_error(2, {"paper", "hssil", "--frames", "0"}, "--frames");
  expect_error(2, {"paper", "hssil", "--size", "8"}, "--size");
}

}  // namespace
}  // namespace lueur
