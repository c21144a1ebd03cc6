// SPDX-License-Identifier: MIT
// Skins, morph targets, splines and copies of glTF files against what their formulas give.
#include <chrono>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/deform.h"
#include "scene/gltf_export.h"
#include "scene/gltf_test_files.h"

namespace lueur {
namespace {

// Four joints a vertex; the third vertex of the triangle follows joint 1 to three quarters.
std::string skin_bytes() {
  // Joint 1 stands at (0, 1, 0): its inverse bind matrix moves by (0, -1, 0).
  return bytes_of<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}) +
         bytes_of<float>({2, 0, 0, 0, 1, 0, 0, 0, 0.75f, 0.25f, 0, 0}) +
         bytes_of<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                          1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
}

// `triangle_json()` skinned by nodes 1 and 2, of which 2 turns by a quarter around z. Its own node
// is far away, which must not matter.
std::string skinned_json() {
  std::string json =
      with(triangle_json(), R"({"POSITION":0})", R"({"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3})");
  json = with(json, R"("nodes":[{"mesh":0}])",
              R"("skins":[{"joints":[1,2],"inverseBindMatrices":4}],
"nodes":[{"mesh":0,"skin":0,"translation":[100,0,0],"children":[1]},
{"children":[2],"translation":[-100,0,0]},
{"translation":[0,1,0],"rotation":[0,0,0.70710678,0.70710678]}])");
  json = with(json, R"("bufferViews":[)", R"("bufferViews":[)");
  json = with(json, R"(}],
"bufferViews")",
              R"(},{"byteLength":188,"uri":")" + data_uri(skin_bytes()) + R"("}],
"bufferViews")");
  json = with(json, R"("byteLength":6}])", R"("byteLength":6},
{"buffer":1,"byteLength":12},{"buffer":1,"byteOffset":12,"byteLength":48},
{"buffer":1,"byteOffset":60,"byteLength":128}])");
  return with(json, R"("count":3,"type":"SCALAR"}])", R"("count":3,"type":"SCALAR"},
{"bufferView":2,"componentType":5121,"count":3,"type":"VEC4"},
{"bufferView":3,"componentType":5126,"count":3,"type":"VEC4"},
{"bufferView":4,"componentType":5126,"count":2,"type":"MAT4"}])");
}

void expect_near(const glm::vec3& got, const glm::vec3& want, const char* what) {
  EXPECT_LT(glm::distance(got, want), 1e-5f)
      << what << ": " << got.x << " " << got.y << " " << got.z;
}

std::vector<Vertex> shaped(const Scene& scene, float time_s = 0.0f) {
  const auto deformed = deformed_instances(scene, pose(scene, time_s), time_s);
  EXPECT_EQ(deformed.size(), 1u);
  return deformed.at(0).vertices;
}

TEST_F(GltfTest, SkinMovesVerticesByItsJointsAndNotByTheNode) {
  const auto scene = load(skinned_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->instances[0].skin, 0);
  const std::vector<Vertex> vertices = shaped(*scene);
  // Weights of 2 are normalised to 1.
  expect_near(vertices[0].position, {0, 0, 0}, "joint 0");
  expect_near(vertices[1].position, {1, 0, 0}, "joint 0");
  // (0, 1, 0) is joint 1's own place: it stays there, whatever that turns.
  expect_near(vertices[2].position, {0, 1, 0}, "the joint's place");
  // The box is the skinned one's, not that of the node, which is 100 m away.
  EXPECT_NEAR(bounds_at(*scene, 0.0f).max.x, 1.0f, 1e-5f);
  EXPECT_NEAR(bounds_at(*scene, 0.0f).min.x, 0.0f, 1e-5f);
}

TEST_F(GltfTest, SkinBlendsMatricesByWeight) {
  auto scene = load(skinned_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  // Lift the third vertex off the joint: joint 1 takes (0, 3, 0), two above it, to (-2, 1, 0).
  Vertex& vertex = scene->meshes[0].vertices[2];
  vertex.position = {0, 3, 0};
  vertex.normal = {0, 1, 0};
  const Vertex moved = shaped(*scene)[2];
  expect_near(moved.position, 0.75f * glm::vec3(-2, 1, 0) + 0.25f * glm::vec3(0, 3, 0), "blend");
  // The blended matrix is 3/4 of the quarter turn plus 1/4 of the identity: a turn and a scale,
  // which leaves angles as they are.
  expect_near(moved.normal, glm::normalize(glm::vec3(-0.75f, 0.25f, 0)), "normal");
}

TEST_F(GltfTest, DeformedMeshesCanBeMadeRigid) {
  const auto scene = load(skinned_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const Scene rigid = with_deformed_meshes(*scene, 0.0f);
  EXPECT_FALSE(is_deformed(rigid, rigid.instances[0]));
  const auto want = shaped(*scene);
  const auto world = world_from_instance(rigid.instances[0], pose(rigid, 0.0f));
  const Mesh& mesh = rigid.meshes[static_cast<size_t>(rigid.instances[0].mesh)];
  for (size_t i = 0; i < want.size(); ++i)
    expect_near(glm::vec3(world * glm::vec4(mesh.vertices[i].position, 1.0f)), want[i].position,
                "vertex");
}

TEST_F(GltfTest, WrongSkinsAreRefused) {
  expect_refused(with(skinned_json(), R"("joints":[1,2])", R"("joints":[1])"),
                 {"nodes[0].skin", "joint 1", "the skin has 1"});
  expect_refused(with(skinned_json(), R"("children":[2],)", ""),
                 {"skins[0].joints", "node 2 is not in the scene"});
  expect_refused(with(skinned_json(), R"("joints":[1,2])", R"("joints":[1,7])"),
                 {"skins[0].joints", "7 is not below"});
  expect_refused(with(skinned_json(), R"("count":2,"type":"MAT4")", R"("count":1,"type":"MAT4")"),
                 {"skins[0].inverseBindMatrices", "1 elements"});
  expect_refused(with(skinned_json(), R"("componentType":5121,"count":3,"type":"VEC4")",
                      R"("componentType":5121,"count":3,"type":"VEC3")"),
                 {"JOINTS_0"});
}

// Each instance has vertices of its own: many nodes of one small mesh can take all memory.
TEST_F(GltfTest, DeformedInstancesCountAgainstTheLimit) {
  std::string more;
  for (int i = 0; i < 20; ++i) more += R"(,{"mesh":0,"skin":0})";
  std::string json =
      with(skinned_json(), R"("rotation":[0,0,0.70710678,0.70710678]})",
           R"("children":[3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22]})" + more);
  LoadLimits limits;
  limits.vertices = 6 + 21 * 5;  // the mesh' 3 and, flat, 3 more; an instance's 3 and two joints
  const auto scene = load(json, limits);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->instances.size(), 21u);
  --limits.vertices;
  expect_refused(json, {"nodes[22]", "more than 110 vertices"}, limits);
}

// The triangle with two targets: one lifts its second vertex by z = 1, one moves all by x = 2.
std::string morphed_json() {
  const std::string bytes = bytes_of<float>({0, 0, 0, 0, 0, 1, 0, 0, 0}) +
                            bytes_of<float>({2, 0, 0, 2, 0, 0, 2, 0, 0}) + bytes_of<float>({0, 2}) +
                            // Splines: for each of two keys a tangent, a value, a tangent, of two
                            // weights each.
                            bytes_of<float>({0, 0, 0, 0, 3, 0, 0, 0, 1, 4, 0, 0});
  std::string json = with(triangle_json(), R"("indices":1})", R"("indices":1,
"targets":[{"POSITION":2},{"POSITION":3}]}],"weights":[0.5,0)");
  json = with(json, R"("nodes":[{"mesh":0}])", R"("nodes":[{"mesh":0}],
"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],
"samplers":[{"input":4,"output":5,"interpolation":"CUBICSPLINE"}]}])");
  json = with(json, R"(}],
"bufferViews")",
              R"(},{"byteLength":128,"uri":")" + data_uri(bytes) + R"("}],
"bufferViews")");
  json = with(json, R"("byteLength":6}])", R"("byteLength":6},
{"buffer":1,"byteLength":36},{"buffer":1,"byteOffset":36,"byteLength":36},
{"buffer":1,"byteOffset":72,"byteLength":8},{"buffer":1,"byteOffset":80,"byteLength":48}])");
  return with(json, R"("count":3,"type":"SCALAR"}])", R"("count":3,"type":"SCALAR"},
{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":3,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":4,"componentType":5126,"count":2,"type":"SCALAR"},
{"bufferView":5,"componentType":5126,"count":12,"type":"SCALAR"}])");
}

TEST_F(GltfTest, MorphTargetsAddUpByWeight) {
  auto scene = load(morphed_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  scene->animation.clear();
  expect_near(shaped(*scene)[1].position, {1, 0, 0.5f}, "the mesh' weights");
  scene->instances[0].morph_weights = {2.0f, -1.0f};
  expect_near(shaped(*scene)[1].position, {-1, 0, 2}, "both");
  expect_near(shaped(*scene)[0].position, {-2, 0, 0}, "both");
}

// Channels times instances would be ten thousand million steps.
TEST_F(GltfTest, ManyWeightsOfManyNodesAreQuick) {
  auto scene = load(morphed_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const MeshInstance instance = scene->instances[0];
  const AnimationChannel channel = scene->animation[0];
  for (int32_t i = 1; i < 100'000; ++i) {
    scene->instances.push_back(instance);
    scene->instances.back().node = i;
    scene->animation.push_back(channel);
    scene->animation.back().node = i;
  }
  const auto start = std::chrono::steady_clock::now();
  const auto weights = morph_weights(*scene, 0.7f);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  EXPECT_EQ(weights.back()[0], weights[0][0]);
}

// Keys are finite, what they multiply to may not be: vertices stay, and nodes are at rest.
TEST_F(GltfTest, AnimationNeverLeavesTheRangeOfFloats) {
  auto scene = load(morphed_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  for (AnimationChannel& channel : scene->animation)
    for (glm::vec4& value : channel.values) value *= 3e38f;
  scene->meshes[0].morph_targets[1].positions[0] = {0, 1e10f, 0};
  expect_near(shaped(*scene, 1.5f)[0].position, {0, 0, 0}, "where the mesh has it");

  scene->animation = {
      {.node = 0, .times_s = {0, 1, 2}, .values = {glm::vec4(3e38f), glm::vec4(1), glm::vec4(1)}}};
  Node parent;
  parent.scale = glm::vec3(1e10f);
  scene->nodes.insert(scene->nodes.begin(), parent);
  scene->nodes[1].parent = 0;
  scene->animation[0].node = 1;
  EXPECT_EQ(pose(*scene, 0.0f)[1], pose(*scene, 0.0f)[0]);
  EXPECT_NE(pose(*scene, 1.5f)[1], pose(*scene, 1.5f)[0]);
}

TEST_F(GltfTest, NodeWeightsTakeThePlaceOfTheMesh) {
  auto scene = load(with(morphed_json(), R"([{"mesh":0}])", R"([{"mesh":0,"weights":[0.25,1]}])"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->instances[0].morph_weights, (std::vector<float>{0.25f, 1.0f}));
}

TEST_F(GltfTest, CubicSplinesAreHermite) {
  const auto scene = load(morphed_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->animation.size(), 2u);
  // From 0 with slope 3 to 1 with slope 0 within 2 s, for the first weight; and from 0 to 4, flat
  // at both ends, for the second.
  for (const float time_s : {0.0f, 0.5f, 1.0f, 1.7f}) {
    const float t = time_s / 2.0f;
    const float h10 = t * t * t - 2 * t * t + t, h01 = 3 * t * t - 2 * t * t * t;
    const std::vector<float> weights = morph_weights(*scene, time_s).at(0);
    ASSERT_EQ(weights.size(), 2u);
    EXPECT_NEAR(weights[0], 2.0f * 3.0f * h10 + h01, 1e-5f) << time_s;
    EXPECT_NEAR(weights[1], 4.0f * h01, 1e-5f) << time_s;
  }
}

TEST_F(GltfTest, WeightsThatFitNoKeysAreRefused) {
  expect_refused(with(morphed_json(), R"("count":12)", R"("count":11)"),
                 {"animations[0].samplers[0].output", "does not fit"});
}

TEST_F(GltfTest, ExportKeepsSkinsAndTargets) {
  for (const std::string& json : {skinned_json(), morphed_json()}) {
    const auto scene = load(json);
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    const auto path = folder_ / "asset" / "out.glb";
    ASSERT_TRUE(export_glb(*scene, path).ok());
    const auto again = load_gltf(path);
    ASSERT_TRUE(again.ok()) << again.error().message;
    for (const float time_s : {0.0f, 0.7f}) {
      const auto want = shaped(*scene, time_s), got = shaped(*again, time_s);
      ASSERT_EQ(got.size(), want.size());
      for (size_t i = 0; i < got.size(); ++i)
        expect_near(got[i].position, want[i].position, "vertex");
    }
  }
}

std::string instanced_json() {
  const std::string bytes = bytes_of<float>({1, 0, 0, 0, 2, 0, 0, 0, 3}) +
                            bytes_of<int16_t>({0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 0, 32767});
  std::string json = with(triangle_json(), R"("nodes":[{"mesh":0}])",
                          R"("nodes":[{"mesh":0,"translation":[10,0,0],"extensions":
{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":2,"ROTATION":3}}}}])");
  json = with(json, R"(}],
"bufferViews")",
              R"(},{"byteLength":60,"uri":")" + data_uri(bytes) + R"("}],
"bufferViews")");
  json = with(json, R"("byteLength":6}])", R"("byteLength":6},
{"buffer":1,"byteLength":36},{"buffer":1,"byteOffset":36,"byteLength":24}])");
  return with(json, R"("count":3,"type":"SCALAR"}])", R"("count":3,"type":"SCALAR"},
{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":3,"componentType":5122,"normalized":true,"count":3,"type":"VEC4"}])");
}

TEST_F(GltfTest, CopiesStandWhereTheirAttributesSay) {
  const auto scene = load(instanced_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->meshes.size(), 1u);
  ASSERT_EQ(scene->instances.size(), 3u);
  const auto world = pose(*scene, 0.0f);
  const auto corner = [&](size_t i) {
    return glm::vec3(world_from_instance(scene->instances[i], world) * glm::vec4(1, 0, 0, 1));
  };
  expect_near(corner(0), {12, 0, 0}, "first");
  // A quarter turn around z, to half of a 16-bit step.
  EXPECT_LT(glm::distance(corner(1), glm::vec3(10, 3, 0)), 1e-4f);
  expect_near(corner(2), {11, 0, 3}, "third");
  expect_refused(
      with(instanced_json(), R"("normalized":true,"count":3)", R"("normalized":true,"count":2)"),
      {"EXT_mesh_gpu_instancing.attributes", "differ in their count"});
  LoadLimits limits;
  limits.nodes = 3;
  expect_refused(instanced_json(), {"EXT_mesh_gpu_instancing", "1 to 2"}, limits);
}

}  // namespace
}  // namespace lueur
