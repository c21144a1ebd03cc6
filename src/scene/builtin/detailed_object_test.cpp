// SPDX-License-Identifier: MIT
#include "scene/builtin/detailed_object.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scene/builtin/builtin_fixture.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"
#include "scene/gltf_export.h"
#include "scene/scene.h"

namespace lueur {
namespace {

// A red brick 2 x 1 x 4 m that hangs off the origin, lit and filmed by its file, and moving.
Scene brick() {
  Scene scene;
  const int32_t red = builtin::add_material(scene, "brick red", {0.6f, 0.1f, 0.1f});
  builtin::bind_pattern(scene, red, "brick", 16, 1.0f, builtin::masonry_pattern());
  builtin::MeshBuilder builder;
  builder.set_material(red);
  builtin::add_box(builder, {5, 5, 5}, {7, 6, 9}, builtin::Tessellation{10.0f});
  const int32_t node = builtin::add_mesh(scene, builder.finish("brick"));
  builtin::animate_translation(scene, node, 4, [](float t) { return glm::vec3(0, 9 * t, 0); });
  builtin::add_camera(scene, "other camera", {0, 0, 9}, {}, 0.8f);
  scene.lights.push_back({.name = "other light", .node = node});
  return scene;
}

class SceneObject : public testing::TestWithParam<std::string> {};

TEST_P(SceneObject, GivesWayToAnother) {
  const Scene before = make(GetParam());
  const std::filesystem::path file = testing::TempDir() + "/brick, a:b.glb";
  ASSERT_TRUE(export_glb(brick(), file).ok());
  const Scene after = make(GetParam() + ":object=" + file.string());
  EXPECT_EQ(after.cameras.size(), before.cameras.size());
  EXPECT_EQ(after.lights.size(), before.lights.size());
  EXPECT_EQ(after.animation.size(), before.animation.size());
  EXPECT_EQ(after.exposure_ev, before.exposure_ev);
  EXPECT_EQ(after.instances.size(), before.instances.size());
  EXPECT_EQ(after.meshes.size(), before.meshes.size());
  const auto mesh_bounds = [](const Scene& scene, int32_t mesh, float time_s) {
    const std::vector<glm::mat4> world = pose(scene, time_s);
    Bounds box{glm::vec3(1e9f), glm::vec3(-1e9f)};
    for (const MeshInstance& instance : scene.instances) {
      if (instance.mesh != mesh) continue;
      for (const Vertex& v : scene.meshes[mesh].vertices) {
        const glm::vec3 p = world[instance.node] * glm::vec4(v.position, 1);
        box = {glm::min(box.min, p), glm::max(box.max, p)};
      }
    }
    return box;
  };
  const auto index_of = [](const Scene& scene, const char* name) {
    const auto found = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                    [&](const Mesh& mesh) { return mesh.name == name; });
    EXPECT_NE(found, scene.meshes.end()) << name;
    return int32_t(found - scene.meshes.begin());
  };

  // It keeps its proportions, fills the old box one way, and stands in its middle, on its floor;
  // at the start only, as the boxes' own axes turn.
  const Bounds was = mesh_bounds(before, index_of(before, "detailed object"), 0.0f);
  const int32_t brick = index_of(after, "brick");
  const Mesh& mesh = after.meshes[brick];
  EXPECT_EQ(mesh.indices.size(), 36u);
  const std::vector<glm::mat4> world = pose(after, 0.0f);
  for (const MeshInstance& instance : after.instances) {
    if (instance.mesh != brick) continue;
    const glm::mat4& m = world[instance.node];
    const float scale = glm::length(glm::vec3(m[0]));
    EXPECT_NEAR(glm::length(glm::vec3(m[1])), scale, 1e-4f * scale);
    EXPECT_NEAR(glm::length(glm::vec3(m[2])), scale, 1e-4f * scale);
    EXPECT_LT(scale, 1.0f);  // four metres do not fit
  }
  const Bounds is = mesh_bounds(after, brick, 0.0f);
  EXPECT_NEAR(is.min.y, was.min.y, 1e-3f);
  for (const int axis : {0, 1, 2}) {
    EXPECT_GT(is.min[axis], was.min[axis] - 0.3f);
    EXPECT_LT(is.max[axis], was.max[axis] + 0.3f);
  }

  // Its material and textures came along.
  const Material& material = after.materials[mesh.primitives.at(0).material];
  EXPECT_EQ(material.name, "brick red");
  ASSERT_LT(size_t(material.base_color_texture.texture), after.textures.size());
  EXPECT_EQ(after.textures[material.base_color_texture.texture].width, 16u);

  // It goes where the object went.
  const Bounds later = mesh_bounds(after, brick, 3.0f);
  const Bounds object_later = mesh_bounds(before, index_of(before, "detailed object"), 3.0f);
  EXPECT_NEAR(later.min.y, object_later.min.y, 1e-3f);
}

INSTANTIATE_TEST_SUITE_P(Builtin, SceneObject, testing::Values("divider-room", "floating-object"),
                         [](const auto& instance) {
                           return instance.param.substr(0, instance.param.find('-'));
                         });

TEST(SceneObjects, AreInTheScenesThatSaySo) {
  for (const BuiltinScene& scene : builtin_scenes())
    EXPECT_EQ(builtin::has_detailed_object(make(std::string(scene.name))), scene.has_object)
        << scene.name;
}

TEST(SceneObjects, RefuseFilesThatDrawNothing) {
  const std::filesystem::path file = testing::TempDir() + "/point.glb";
  Scene point = brick();
  for (Vertex& v : point.meshes[0].vertices) v.position = glm::vec3(1.0f);
  ASSERT_TRUE(export_glb(point, file).ok());
  for (const std::string& path : {file.string(), std::string("missing.glb")}) {
    const Result<Scene> scene = make_builtin_scene("floating-object:object=" + path);
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().kind, ErrorKind::input);
    EXPECT_NE(scene.error().message.find(path), std::string::npos) << scene.error().message;
  }
}

}  // namespace
}  // namespace lueur
