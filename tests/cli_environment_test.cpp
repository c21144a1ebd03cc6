// SPDX-License-Identifier: MIT
// Environments on the command line, around a scene of an OBJ file.
#include <gtest/gtest.h>

#include <string>

#include "base/file.h"
#include "image/exr.h"
#include "support/cli.h"

namespace lueur {
namespace {

class CliEnvironment : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    // A small square, so that what is behind it fills the corners; and a sky of radiance 3.
    write("square.mtl", "newmtl m\nKd 0.5 0.5 0.5\n");
    write("square.obj",
          "mtllib square.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl m\nf 1 2 3 4\n");
    write("sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\3\3\3\x88\3\3\3\x88");
  }
  void write(const std::string& name, const std::string& content) {
    ASSERT_TRUE(write_file(folder_ / name, content).ok());
  }
  // The first pixel of the file's main picture.
  float corner(const std::string& name) {
    const auto layers = read_exr(folder_ / name);
    EXPECT_TRUE(layers.ok());
    return layers.ok() ? (*layers)[0].image.at(0, 0, 0) : -1.0f;
  }
};

TEST_F(CliEnvironment, IsBehindTheSceneInEveryPicture) {
  const Ended rendered = run({"render", "square.obj", "--env", "sky.hdr", "--env-intensity", "2",
                              "--size", "32x32", "-o", "r.exr"});
  EXPECT_EQ(rendered.code, 0) << rendered.err;
  EXPECT_NE(rendered.err.find("but the environment"), std::string::npos) << rendered.err;
  EXPECT_EQ(corner("r.exr"), 6.0f);
  ExrAttributes attributes;
  ASSERT_TRUE(read_exr(folder_ / "r.exr", &attributes).ok());
  EXPECT_EQ(attributes["lueur.environment"],
            R"({"file":"sky.hdr","rotation_deg":0.0,"intensity":2.0})");
  const Ended traced = run({"reference", "square.obj", "--env", "sky.hdr", "--env-intensity", "2",
                            "--size", "32x32", "--spp", "16", "-o", "t.exr"});
  EXPECT_EQ(traced.code, 0) << traced.err;
  EXPECT_EQ(corner("t.exr"), 6.0f);
  EXPECT_EQ(run({"render", "square.obj", "--size", "32x32", "-o", "d.exr"}).code, 0);
  EXPECT_EQ(corner("d.exr"), 0.0f);
}

TEST_F(CliEnvironment, BadOnesAreOneLine) {
  const auto with = [](const Arguments& more) {
    Arguments arguments = {"render", "square.obj", "-o", "x.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  expect_error(2, with({"--env-rotation", "5"}), "--env");
  expect_error(2, with({"--env-intensity", "5"}), "--env");
  expect_error(2, with({"--env", "sky.hdr", "--env-intensity", "-1"}), "--env-intensity");
  expect_error(2, with({"--env", "sky.hdr", "--env-rotation", "nan"}), "--env-rotation");
  expect_error(3, with({"--env", "missing.hdr"}), "missing.hdr");
  expect_error(3, with({"--env", "."}));
  expect_error(3, with({"--env", "square.mtl"}), "square.mtl");
  write("cut.hdr", "#?RADIANCE\n\n-Y 1 +X 2\n\3\3");
  expect_error(3, with({"--env", "cut.hdr"}), "cut.hdr");
  write("broken.obj", "v 0 0 0\nf 1 2 3\n");
  expect_error(3, {"render", "broken.obj", "-o", "x.png"}, "line 2");
  expect_error(3, {"render", "missing.obj", "-o", "x.png"}, "missing.obj");
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
}

}  // namespace
}  // namespace lueur
