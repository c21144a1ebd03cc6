// SPDX-License-Identifier: MIT
#include "scene/gltf_export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.h"
#include "scene/builtin/builtin.h"
#include "scene/deform.h"
#include "scene/gltf_load.h"

namespace lueur {
namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "lueur-export-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

uint32_t word_at(const std::vector<uint8_t>& bytes, size_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, 4);
  return word;
}

nlohmann::json json_of(const std::vector<uint8_t>& glb) {
  return nlohmann::json::parse(glb.begin() + 20, glb.begin() + 20 + word_at(glb, 12));
}

class Exported : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Result<Scene> scene = make_builtin_scene(GetParam());
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    scene_ = std::move(*scene);
    file_ = folder_.path() / "scene.glb";
    const Result<void> result = export_glb(scene_, file_);
    ASSERT_TRUE(result.ok()) << result.error().message;
  }

  TemporaryFolder folder_;
  fs::path file_;
  Scene scene_;
};

TEST_P(Exported, HasAllOfTheScene) {
  const Result<std::vector<uint8_t>> file = read_file(file_, uint64_t{1} << 30);
  ASSERT_TRUE(file.ok()) << file.error().message;
  ASSERT_GT(file->size(), 28u);
  EXPECT_EQ(std::memcmp(file->data(), "glTF", 4), 0);
  EXPECT_EQ(word_at(*file, 4), 2u);
  EXPECT_EQ(word_at(*file, 8), file->size());
  EXPECT_EQ(file->size() % 4, 0u);

  const nlohmann::json json = json_of(*file);
  EXPECT_EQ(json["asset"]["generator"], "lueur");
  EXPECT_EQ(json["meshes"].size(), scene_.meshes.size());
  EXPECT_EQ(json["materials"].size(), scene_.materials.size());
  EXPECT_EQ(json["nodes"].size(), scene_.nodes.size());
  EXPECT_EQ(json["cameras"].size(), scene_.cameras.size());
  EXPECT_EQ(json["extensions"]["KHR_lights_punctual"]["lights"].size(), scene_.lights.size());
  EXPECT_EQ(json["animations"][0]["channels"].size(), scene_.animation.size());
  EXPECT_EQ(json.value("textures", nlohmann::json::array()).size(), scene_.textures.size());

  // Every view lies in the one buffer.
  const uint64_t bytes = json["buffers"][0]["byteLength"];
  for (const nlohmann::json& view : json["bufferViews"])
    EXPECT_LE(view["byteOffset"].get<uint64_t>() + view["byteLength"].get<uint64_t>(), bytes);

  // The indices drawn are the scene's.
  for (size_t m = 0; m < scene_.meshes.size(); ++m) {
    uint64_t count = 0;
    for (const nlohmann::json& p : json["meshes"][m]["primitives"])
      count += json["accessors"][p["indices"].get<size_t>()]["count"].get<uint64_t>();
    EXPECT_EQ(count, scene_.meshes[m].indices.size()) << scene_.meshes[m].name;
  }
}

TEST_P(Exported, ComesBackThroughTheLoader) {
  const Result<Scene> loaded = load_gltf(file_);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->warnings, std::vector<std::string>());
  EXPECT_EQ(triangle_count(*loaded), triangle_count(scene_));

  // The same box at any time: geometry, poses and animation.
  for (const float time_s : {0.0f, 2.6f, 7.1f}) {
    const Bounds want = bounds_at(scene_, time_s);
    const Bounds got = bounds_at(*loaded, time_s);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(got.min[axis], want.min[axis], 1e-4f) << "axis " << axis << " at " << time_s;
      EXPECT_NEAR(got.max[axis], want.max[axis], 1e-4f) << "axis " << axis << " at " << time_s;
    }
  }

  const std::vector<glm::mat4> want_pose = pose(scene_, 2.6f), got_pose = pose(*loaded, 2.6f);
  ASSERT_EQ(loaded->lights.size(), scene_.lights.size());
  for (size_t k = 0; k < scene_.lights.size(); ++k) {
    const Light &want = scene_.lights[k], &got = loaded->lights[k];
    EXPECT_EQ(got.kind, want.kind);
    EXPECT_EQ(got.intensity, want.intensity);
    EXPECT_EQ(got.color, want.color);
    if (want.kind == LightKind::spot) {
      EXPECT_EQ(got.inner_cone_rad, want.inner_cone_rad);
      EXPECT_EQ(got.outer_cone_rad, want.outer_cone_rad);
    }
    for (int column = 0; column < 4; ++column)
      EXPECT_LT(glm::distance(got_pose[got.node][column], want_pose[want.node][column]), 1e-5f);
  }
  ASSERT_EQ(loaded->cameras.size(), scene_.cameras.size());
  for (size_t k = 0; k < scene_.cameras.size(); ++k) {
    const Camera &want = scene_.cameras[k], &got = loaded->cameras[k];
    EXPECT_EQ(got.vertical_fov_rad, want.vertical_fov_rad);
    for (int column = 0; column < 4; ++column)
      EXPECT_LT(glm::distance(got_pose[got.node][column], want_pose[want.node][column]), 1e-5f);
  }

  // The loader may order materials anew; in these scenes their names are unique.
  ASSERT_EQ(loaded->materials.size(), scene_.materials.size());
  for (const Material& want : scene_.materials) {
    const auto found = std::find_if(loaded->materials.begin(), loaded->materials.end(),
                                    [&](const Material& m) { return m.name == want.name; });
    ASSERT_NE(found, loaded->materials.end()) << want.name;
    const Material& got = *found;
    EXPECT_EQ(got.base_color, want.base_color);
    EXPECT_EQ(got.roughness, want.roughness);
    EXPECT_EQ(got.metallic, want.metallic);
    EXPECT_EQ(got.specular, want.specular);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(got.emission[c], want.emission[c], 1e-5f * want.emission[c]);
    ASSERT_EQ(got.base_color_texture.is_used(), want.base_color_texture.is_used());
    if (!want.base_color_texture.is_used()) continue;
    EXPECT_TRUE(loaded->textures[got.base_color_texture.texture].rgba ==
                scene_.textures[want.base_color_texture.texture].rgba);
  }
}

INSTANTIATE_TEST_SUITE_P(Builtin, Exported,
                         testing::Values("atrium:triangles=20000", "cornell", "spot-floor"),
                         [](const auto& instance) {
                           std::string name = instance.param.substr(0, instance.param.find(':'));
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

// One triangle on a node with a sheared matrix that carries two meshes.
Scene small_scene() {
  Scene scene;
  scene.materials.emplace_back();
  scene.materials[0].alpha_mode = AlphaMode::mask;
  scene.materials[0].double_sided = true;
  Mesh mesh;
  mesh.name = "triangle";
  for (const glm::vec3 p : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
    mesh.vertices.push_back({p, {0, 0, 1}, {1, 0, 0, 1}, {p.x, p.y}});
  mesh.indices = {0, 1, 2};
  mesh.primitives = {{0, 3, 0}};
  Node node;
  node.name = "sheared";
  node.matrix = glm::mat4(1.0f);
  (*node.matrix)[1][0] = 0.5f;
  scene.nodes = {node};
  Mesh empty;
  empty.name = "empty";
  scene.meshes = {empty, mesh};
  scene.instances = {{0, 0}, {0, 1}, {0, 1}};
  return scene;
}

TEST(ExportGlb, KeepsMatricesAndGivesExtraMeshesNodesOfTheirOwn) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "small.glb";
  const Scene scene = small_scene();
  ASSERT_TRUE(export_glb(scene, file).ok());
  const Result<std::vector<uint8_t>> bytes = read_file(file, 1 << 20);
  ASSERT_TRUE(bytes.ok());
  const nlohmann::json json = json_of(*bytes);
  EXPECT_EQ(json["meshes"].size(), 1u);  // the empty mesh is left out
  EXPECT_EQ(json["nodes"].size(), 2u);
  EXPECT_EQ(json["nodes"][0]["matrix"][4], 0.5);
  EXPECT_EQ(json["nodes"][0]["children"], nlohmann::json::array({1}));
  EXPECT_EQ(json["nodes"][1]["mesh"], 0);
  EXPECT_EQ(json["materials"][0]["alphaMode"], "MASK");
  EXPECT_EQ(json["materials"][0]["doubleSided"], true);

  const Result<Scene> loaded = load_gltf(file);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(triangle_count(*loaded), 2u);
  EXPECT_FLOAT_EQ(bounds_at(*loaded, 0).max.x, 1.0f);
}

TEST(ExportGlb, KeepsWhatPassesNoLightOn) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "small.glb";
  Scene scene = small_scene();
  scene.instances[1].passes_light_on = false;
  ASSERT_TRUE(export_glb(scene, file).ok());
  const Result<Scene> loaded = load_gltf(file);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  for (const std::string& warning : loaded->warnings)
    EXPECT_EQ(warning.find("extras"), std::string::npos) << warning;
  ASSERT_EQ(loaded->instances.size(), 2u);  // the empty mesh is left out
  EXPECT_FALSE(loaded->instances[0].passes_light_on);
  EXPECT_TRUE(loaded->instances[1].passes_light_on);
}

TEST(ExportGlb, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "missing" / "scene.glb";
  const Result<void> result = export_glb(small_scene(), file);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::output);
  EXPECT_NE(result.error().message.find(file.string()), std::string::npos);
}

}  // namespace
}  // namespace lueur
