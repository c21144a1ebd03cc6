// SPDX-License-Identifier: MIT
#include "scene/moving_objects.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/deform.h"

namespace lueur {
namespace {

using Objects = std::vector<int32_t>;

// A triangle of one metre, for instances on nodes of a tree that tests make:
//   0 ── 1 ── 2
//   └─── 3        4 (a root, as 0)
Scene tree(std::initializer_list<int32_t> nodes_of_instances) {
  Scene scene;
  scene.nodes.resize(5);
  scene.nodes[1].parent = scene.nodes[3].parent = 0;
  scene.nodes[2].parent = 1;
  Mesh mesh;
  for (const glm::vec3 p : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
    mesh.vertices.push_back({p, {0, 0, 1}, {1, 0, 0, 1}, {0, 0}});
  mesh.indices = {0, 1, 2};
  mesh.primitives = {{0, 3, 0}};
  scene.meshes = {mesh};
  scene.materials.resize(1);
  for (const int32_t node : nodes_of_instances) scene.instances.push_back({node, 0});
  return scene;
}

void animate(Scene& scene, int32_t node, const glm::vec4& from, const glm::vec4& to,
             AnimationPath path = AnimationPath::translation) {
  AnimationChannel channel;
  channel.node = node;
  channel.path = path;
  channel.times_s = {0.0f, 1.0f};
  channel.values = {from, to};
  scene.animation.push_back(channel);
}

void animate(Scene& scene, int32_t node) {
  animate(scene, node, glm::vec4(0.0f), {8, 0, 0, 0});
}

void add_skin(Scene& scene, MeshInstance& instance, int32_t joint) {
  instance.skin = static_cast<int32_t>(scene.skins.size());
  scene.skins.push_back({"skin", {joint}, {glm::mat4(1.0f)}});
  scene.meshes[static_cast<size_t>(instance.mesh)].influences.assign(
      3, {glm::u16vec4(uint16_t{0}), {1, 0, 0, 0}});
}

void add_morph_target(Mesh& mesh) {
  mesh.morph_targets.push_back({std::vector<glm::vec3>(3, glm::vec3(0, 0, 2)), {}, {}});
}

TEST(MovingObjects, StandStillWithoutAnimation) {
  const MovingObjects found = moving_objects(tree({0, 1, 4}));
  EXPECT_EQ(found.count, 0);
  EXPECT_EQ(found.of_instance, (Objects{kNone, kNone, kNone}));
}

TEST(MovingObjects, AreAllBelowTheTopmostNodeThatMoves) {
  Scene scene = tree({3, 2, 4, 1, 0});
  animate(scene, 2);
  EXPECT_EQ(moving_objects(scene).of_instance, (Objects{kNone, 0, kNone, kNone, kNone}));
  animate(scene, 1);
  EXPECT_EQ(moving_objects(scene).of_instance, (Objects{kNone, 0, kNone, 0, kNone}));
  animate(scene, 4);
  EXPECT_EQ(moving_objects(scene).of_instance, (Objects{kNone, 0, 1, 0, kNone}));
  animate(scene, 0);
  const MovingObjects found = moving_objects(scene);
  EXPECT_EQ(found.of_instance, (Objects{0, 0, 1, 0, 0}));
  EXPECT_EQ(found.count, 2);
}

TEST(MovingObjects, AreNotWhatAnimationLeavesInPlace) {
  Scene scene = tree({0, 1, 4});
  animate(scene, 0, glm::vec4(1.0f), glm::vec4(1.0f));
  animate(scene, 1);
  scene.nodes[1].matrix = glm::mat4(1.0f);
  scene.animation.push_back({.node = 4});
  EXPECT_EQ(moving_objects(scene).count, 0);
}

TEST(MovingObjects, AreMovedByJointsWhereTheyHaveASkin) {
  Scene scene = tree({4, 4, 3});
  // A joint below the node that moves, and another mesh' node that moves.
  add_skin(scene, scene.instances[0], 2);
  animate(scene, 1);
  EXPECT_EQ(moving_objects(scene).of_instance, (Objects{0, kNone, kNone}));
  add_skin(scene, scene.instances[2], 1);
  EXPECT_EQ(moving_objects(scene).of_instance, (Objects{0, kNone, 1}));
  animate(scene, 0);
  EXPECT_EQ(moving_objects(scene).of_instance, (Objects{0, kNone, 1}));

  Scene held_by_joint = tree({4});
  add_skin(held_by_joint, held_by_joint.instances[0], 2);
  animate(held_by_joint, 4);
  EXPECT_EQ(moving_objects(held_by_joint).count, 0);
}

TEST(MovingObjects, AreWhatMorphTargetsMove) {
  Scene scene = tree({0, 0, 1});
  scene.meshes.push_back(scene.meshes[0]);
  add_morph_target(scene.meshes[1]);
  scene.instances[1].mesh = scene.instances[2].mesh = 1;
  animate(scene, 0, glm::vec4(0.0f), glm::vec4(1.0f), AnimationPath::morph_weight);
  // Weights are of the node's own meshes, and move nothing below it.
  EXPECT_EQ(moving_objects(scene).of_instance, (Objects{kNone, 0, kNone}));
}

TEST(MovingObjects, EndWhereNamesDo) {
  Scene scene = tree({});
  scene.nodes.clear();
  for (int32_t i = 0; i < kMostMovingObjects + 2; ++i) {
    scene.nodes.emplace_back();
    scene.instances.push_back({i, 0});
    animate(scene, i);
  }
  // One more on the first node, one more on one that has none.
  scene.instances.push_back({0, 0});
  scene.instances.push_back({kMostMovingObjects, 0});
  const MovingObjects found = moving_objects(scene);
  EXPECT_EQ(found.count, kMostMovingObjects);
  for (int32_t i = 0; i < kMostMovingObjects; ++i)
    EXPECT_EQ(found.of_instance[static_cast<size_t>(i)], i);
  const Objects last(found.of_instance.end() - 4, found.of_instance.end());
  EXPECT_EQ(last, (Objects{kNone, kNone, 0, kNone}));
}

void expect_box(const Bounds& box, const glm::vec3& min, const glm::vec3& max) {
  EXPECT_EQ(box.min, min);
  EXPECT_EQ(box.max, max);
}

TEST(MovingObjects, HaveBoxesThatFollowThem) {
  Scene scene = tree({0, 1, 3, 4});
  scene.nodes[1].translation = {0, 16, 0};
  scene.nodes[3].translation = {0, 0, -4};
  animate(scene, 0);
  animate(scene, 4, glm::vec4(0.0f), {0, -2, 0, 0});
  // What stands still is in none of them.
  scene.nodes.emplace_back().translation = {64, 64, 64};
  scene.instances.push_back({5, 0});
  add_morph_target(scene.meshes.emplace_back(scene.meshes[0]));
  scene.instances[3].mesh = 1;
  scene.instances[3].morph_weights = {0.5f};
  const auto boxes_at = [&](float time_s) {
    const std::vector<glm::mat4> posed = pose(scene, time_s);
    const auto of_instances =
        bounds_of_instances(scene, posed, deformed_instances(scene, posed, time_s));
    return bounds_of_objects(moving_objects(scene), of_instances);
  };
  std::vector<Bounds> boxes = boxes_at(0.5f);
  ASSERT_EQ(boxes.size(), 2u);
  expect_box(boxes[0], {4, 0, -4}, {5, 17, 0});
  expect_box(boxes[1], {0, -1, 1}, {1, 0, 1});
  // Of what is nowhere, a point.
  for (Vertex& vertex : scene.meshes[1].vertices)
    vertex.position.x = std::numeric_limits<float>::quiet_NaN();
  expect_box(boxes_at(0.5f)[1], {0, 0, 0}, {0, 0, 0});
}

}  // namespace
}  // namespace lueur
