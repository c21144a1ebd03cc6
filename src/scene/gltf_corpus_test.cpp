// SPDX-License-Identifier: MIT
// Real files: they load, or are refused by name; none of the broken ones does harm.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/framing.h"
#include "scene/gltf_load.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

std::vector<fs::path> gltf_files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (entry.is_regular_file() && (extension == ".glb" || extension == ".gltf"))
      files.push_back(entry.path());
  }
  return files;
}

// Completes the scene too, and checks what the headers promise.
void expect_sound(const Scene& scene, const std::string& name) {
  Scene completed = scene;
  complete(completed);
  EXPECT_FALSE(completed.cameras.empty()) << name;
  EXPECT_FALSE(completed.materials.empty()) << name;
  for (size_t i = 0; i < completed.nodes.size(); ++i)
    ASSERT_LT(completed.nodes[i].parent, static_cast<int32_t>(i)) << name;
  for (const Mesh& mesh : completed.meshes) {
    for (const uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size()) << name;
    for (const Vertex& vertex : mesh.vertices) {
      ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-3f) << name;
      ASSERT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-3f) << name;
      ASSERT_EQ(std::abs(vertex.tangent.w), 1.0f) << name;
    }
  }
  for (const Texture& texture : completed.textures)
    ASSERT_EQ(texture.rgba.size(), size_t{texture.width} * texture.height * 4) << name;
}

// Loads everything below `folder`; returns how many loaded and how many were refused.
std::pair<int, int> load_all(const fs::path& folder) {
  int loaded = 0;
  int refused = 0;
  for (const fs::path& path : gltf_files_below(folder)) {
    const auto scene = load_gltf(path);
    if (!scene.ok()) {
      ++refused;
      EXPECT_NE(scene.error().message.find(path.filename().string()), std::string::npos);
      EXPECT_EQ(scene.error().message.find('\n'), std::string::npos) << scene.error().message;
      continue;
    }
    ++loaded;
    expect_sound(*scene, path.string());
  }
  std::printf("%s: %d loaded, %d refused\n", folder.filename().c_str(), loaded, refused);
  return {loaded, refused};
}

TEST(GltfCorpus, RealScenesLoad) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  // The refused ones are compressed with Draco; one of them once more with WebP.
  const std::vector<std::pair<const char*, int>> expected_refusals{
      {"sponza_crytek", 1}, {"cornell_bevy", 0},  {"sw_building", 0},
      {"iwer_rooms", 0},    {"khronos_extra", 1}, {"bevy_examples", 0}};
  for (const auto& [folder, refusals] : expected_refusals) {
    const auto [loaded, refused] = load_all(fs::path(data) / folder);
    EXPECT_GT(loaded, 0) << folder;
    EXPECT_EQ(refused, refusals) << folder;
  }
}

TEST(GltfCorpus, BrokenFilesDoNoHarm) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  const auto [loaded, refused] = load_all(fs::path(data) / "gltf_invalid");
  EXPECT_GT(loaded + refused, 0);
  EXPECT_GT(refused, 0);
}

TEST(GltfCorpus, SponzaIsSeenFromInsideInTheSun) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  auto scene = load_gltf(fs::path(data) / "sponza_crytek" / "sponza.glb");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(triangle_count(*scene), 262'267u);
  EXPECT_EQ(scene->materials.size(), 25u);
  complete(*scene);
  ASSERT_EQ(scene->lights.size(), 1u);
  EXPECT_EQ(scene->lights[0].kind, LightKind::directional);
  const auto world = pose(*scene, 0.0f);
  const glm::mat4& camera = world[static_cast<size_t>(scene->cameras[0].node)];
  EXPECT_GT(std::abs(camera[2].x), 0.8f);  // along the hall
  EXPECT_LT(std::abs(camera[3].z), 3.0f);  // in the courtyard
  EXPECT_NEAR(camera[3].y, 1.6f, 0.2f);    // on the ground
}

}  // namespace
}  // namespace lueur
