// SPDX-License-Identifier: MIT
// Small glTF files for tests, made from strings.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "scene/gltf_load.h"
#include "scene/gltf_test_bytes.h"

namespace lueur {

// Replaces the first `from`, which must be there: tests break one thing of a good file.
inline std::string with(std::string text, std::string_view from, std::string_view to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// One triangle (0,0,0) (1,0,0) (0,1,0): 36 bytes of positions, then 6 of 16-bit indices.
inline std::string triangle_bytes() {
  return bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<uint16_t>({0, 1, 2});
}
inline std::string triangle_json() {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],
"meshes":[{"name":"tri","primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"byteLength":42,"uri":")" +
         data_uri(triangle_bytes()) + R"("}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"accessors":[{"bufferView":0,"min":[0,0,0],"max":[1,1,0],"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})";
}

class GltfTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "lueur-gltf-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    std::filesystem::create_directory(folder_ / "asset");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Result<Scene> load(std::string_view content, const LoadLimits& limits = {}) {
    const std::filesystem::path path = folder_ / "asset" / "file.gltf";
    EXPECT_TRUE(write_file(path, content).ok());
    return load_gltf(path, limits);
  }

  // Expects a refusal in one line that names the file and each of `parts`.
  void expect_refused(std::string_view content, const std::vector<std::string>& parts,
                      const LoadLimits& limits = {}) {
    const auto scene = load(content, limits);
    ASSERT_FALSE(scene.ok()) << "expected a refusal naming " << parts[0];
    const std::string& message = scene.error().message;
    EXPECT_EQ(scene.error().kind, ErrorKind::input);
    EXPECT_NE(message.find("file.gltf: "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << message << " lacks " << part;
  }

  std::filesystem::path folder_;
};

}  // namespace lueur
