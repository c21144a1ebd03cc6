// SPDX-License-Identifier: MIT
// Small OBJ assets for tests, made from strings.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "scene/obj_load.h"

namespace lueur {

class ObjTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "lueur-obj-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    std::filesystem::create_directory(folder_ / "asset");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, std::string_view content) {
    ASSERT_TRUE(write_file(folder_ / "asset" / name, content).ok());
  }
  Result<Scene> load(std::string_view content, const LoadLimits& limits = {}) {
    write("file.obj", content);
    return load_obj(folder_ / "asset" / "file.obj", limits);
  }
  // The scene of a good file; an empty one, and a failure, if it is refused.
  Scene loaded(std::string_view content) {
    auto scene = load(content);
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message);
    return scene.ok() ? *scene : Scene{};
  }
  // One triangle with the material `m` that `mtl` describes.
  Scene with_material(std::string_view mtl) {
    write("file.mtl", mtl);
    return loaded(
        "mtllib file.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75\nusemtl m\n"
        "f 1/1 2/1 3/1\n");
  }

  // Expects a refusal in one line that names each of `parts`.
  void expect_refused(std::string_view content, const std::vector<std::string>& parts,
                      const LoadLimits& limits = {}) {
    const auto scene = load(content, limits);
    ASSERT_FALSE(scene.ok()) << "expected a refusal naming " << parts[0];
    const std::string& message = scene.error().message;
    EXPECT_EQ(scene.error().kind, ErrorKind::input);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << message << " lacks " << part;
  }
  static bool warns_of(const Scene& scene, std::string_view what) {
    for (const std::string& line : scene.warnings)
      if (line.find(what) != std::string::npos) return true;
    return false;
  }

  std::filesystem::path folder_;
};

}  // namespace lueur
