// SPDX-License-Identifier: MIT
#include "report/results.h"

#include <gtest/gtest.h>

#include <limits>

#include "report/text.h"

namespace lueur::report {
namespace {

Comparison two_entries() {
  Comparison comparison;
  comparison.title = "title";
  comparison.scene = "cornell";
  comparison.width = 1280;
  comparison.height = 720;
  comparison.exposure_ev = 0.5;
  comparison.command = "lueur compare cornell";
  comparison.warnings = {"a warning"};
  comparison.references = {{"path", "path", 1024, 0.01, 12.5, {}},
                           {"screen", "screen", 64, std::nullopt, 3.0, {}}};
  Entry entry;
  entry.label = "hierarchical, \"fine\"";
  entry.technique = "hierarchical";
  entry.settings = {{"samples", 32}, {"start", "full"}, {"jitter", true}};
  entry.technique_ms = 8.25;
  entry.frame_ms = 20.0;
  entry.passes = {{"hierarchical.gather@0", 5.5}, {"hierarchical.filter@0", 1.25}};
  entry.errors = {{"path", {{"rmse", 0.1}, {"psnr", std::numeric_limits<double>::infinity()}}, {}},
                  {"screen", {{"bias", -0.25}}, {}}};
  Entry none;
  none.label = "none";
  none.technique = "none";
  none.frame_ms = 11.0;
  comparison.entries = {entry, none};
  return comparison;
}

TEST(ResultsJson, HoldsEveryNumber) {
  const Json json = Json::parse(results_json(two_entries()).dump());
  EXPECT_EQ(json["scene"], "cornell");
  EXPECT_EQ(json["size"], Json({1280, 720}));
  EXPECT_EQ(json["tone_map"], "khronos-neutral");
  EXPECT_EQ(json["command"], "lueur compare cornell");
  EXPECT_EQ(json["warnings"][0], "a warning");
  EXPECT_EQ(json["metrics"].size(), 7u);
  EXPECT_EQ(json["metrics"][2]["better"], "higher");
  EXPECT_EQ(json["metrics"][5]["better"], "nearer_zero");
  EXPECT_EQ(json["references"][0]["samples_per_pixel"], 1024);
  EXPECT_EQ(json["references"][0]["relative_error"], 0.01);
  EXPECT_TRUE(json["references"][1]["relative_error"].is_null());
  const Json& entry = json["entries"][0];
  EXPECT_EQ(entry["label"], "hierarchical, \"fine\"");
  EXPECT_EQ(entry["settings"].dump(), R"({"samples":32,"start":"full","jitter":true})");
  EXPECT_EQ(entry["technique_ms"], 8.25);
  EXPECT_EQ(entry["frame_ms"], 20.0);
  EXPECT_EQ(entry["passes"][1]["name"], "hierarchical.filter@0");
  EXPECT_EQ(entry["passes"][1]["ms"], 1.25);
  EXPECT_EQ(entry["errors"]["path"]["rmse"], 0.1);
  EXPECT_TRUE(entry["errors"]["path"]["psnr"].is_null()) << "JSON has no infinity";
  EXPECT_EQ(entry["errors"]["screen"]["bias"], -0.25);
  EXPECT_EQ(json["entries"][1]["errors"], Json::object());
}

TEST(ResultsCsv, ARowForEachEntryAndReference) {
  EXPECT_EQ(results_csv(two_entries()),
            "label,technique,reference,technique_ms,frame_ms,"
            "rmse,rel_mse,psnr,ssim,flip,bias,rmse_scaled\n"
            "\"hierarchical, \"\"fine\"\"\",hierarchical,path,8.25,20,0.1,,,,,,\n"
            "\"hierarchical, \"\"fine\"\"\",hierarchical,screen,8.25,20,,,,,,-0.25,\n"
            "none,none,,0,11,,,,,,,\n");
}

TEST(ResultsCsv, QuotesWhatWouldBreakARow) {
  Comparison comparison = two_entries();
  comparison.entries = {comparison.entries[1]};
  comparison.entries[0].label = "a\nb\xff";
  EXPECT_NE(results_csv(comparison).find("\n\"a\nb\xef\xbf\xbd\",none,"), std::string::npos);
}

TEST(Results, SurviveTextThatIsNotUtf8) {
  Comparison comparison = two_entries();
  comparison.entries[0].label = "\xc3(";
  comparison.entries[0].settings["\xff"] = "\xfe";
  const Json json = Json::parse(json_file(results_json(comparison)));
  EXPECT_EQ(json["entries"][0]["label"], "\xef\xbf\xbd(");
}

}  // namespace
}  // namespace lueur::report
