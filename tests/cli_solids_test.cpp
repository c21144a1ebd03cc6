// SPDX-License-Identifier: MIT
// What `scene info` says of meshes that obstacles are made of, and what is said where settings and
// inputs do not fit each other.
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/cli.h"

namespace lueur {
namespace {

class CliSolids : public Cli {};

TEST_F(CliSolids, InfoNamesTheMeshesThatAreOpen) {
  std::ofstream(folder_ / "open.obj") << "o lid\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const Ended open = run({"scene", "info", "open.obj"});
  ASSERT_EQ(open.code, 0) << open.err;
  EXPECT_NE(open.out.find("closed: 0 of 1 triangles bound solids; open: "), std::string::npos)
      << open.out;
  const auto solids =
      nlohmann::json::parse(run({"scene", "info", "open.obj", "--json"}).out)["solids"];
  EXPECT_EQ(solids["open_triangles"], 1);
  ASSERT_EQ(solids["open_meshes"].size(), 1u);
  EXPECT_EQ(solids["open_meshes"][0]["open_edges"], 3);

  const auto closed =
      nlohmann::json::parse(run({"scene", "info", "cornell", "--json"}).out)["solids"];
  EXPECT_GT(closed["closed_triangles"], 0);
  EXPECT_TRUE(closed["open_meshes"].empty());
}

TEST_F(CliSolids, SettingsThatDoNotFitEachOtherAreOneLine) {
  const auto with = [](std::vector<std::string> settings) {
    Arguments arguments{"render", "cornell", "--size", "16x12", "-o", "x.png"};
    for (const std::string& setting : settings)
      arguments.insert(arguments.end(), {"--set", setting});
    return arguments;
  };
  expect_error(2, with({"interleave=true"}), "interleave=true is for bounces=2");
  expect_error(2, with({"interleave=true", "bounces=2", "feedback=true"}), "choose one");
  expect_error(2, with({"only_level=7"}), "only_level=7 is above levels=6");
  expect_error(2, with({"visibility=first_bounce", "sampling=every_pixel"}), "sampling=sparse");
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
}

}  // namespace
}  // namespace lueur
