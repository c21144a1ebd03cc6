// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/deform.h"

namespace lueur {
namespace {

Scene two_nodes() {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].translation = {1.0f, 2.0f, 3.0f};
  // A quarter turn about y takes x to -z.
  scene.nodes[0].rotation = glm::angleAxis(glm::half_pi<float>(), glm::vec3(0.0f, 1.0f, 0.0f));
  scene.nodes[1].parent = 0;
  scene.nodes[1].translation = {10.0f, 0.0f, 0.0f};
  scene.nodes[1].scale = {2.0f, 3.0f, 4.0f};
  return scene;
}

void expect_point(const glm::mat4& world, const glm::vec3& local, const glm::vec3& expected) {
  const glm::vec3 point(world * glm::vec4(local, 1.0f));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(point[i], expected[i], 1e-5f) << "axis " << i;
}

TEST(Pose, ChildrenFollowTheirParents) {
  const auto world = pose(two_nodes(), 0.0f);
  ASSERT_EQ(world.size(), 2u);
  expect_point(world[0], {0, 0, 0}, {1, 2, 3});
  // Scaled to (2, 3, 4), moved to (12, 3, 4), turned to (4, 3, -12), moved by the parent.
  expect_point(world[1], {1, 1, 1}, {5, 5, -9});
}

TEST(Pose, MatrixTakesThePlaceOfTheParts) {
  Scene scene = two_nodes();
  glm::mat4 shear(1.0f);
  shear[1][0] = 0.5f;
  scene.nodes[1].matrix = shear;
  scene.nodes[0] = Node{};
  expect_point(pose(scene, 0.0f)[1], {0, 2, 0}, {1, 2, 0});
}

TEST(Pose, AnimationInterpolatesAndLoops) {
  Scene scene = two_nodes();
  AnimationChannel move;
  move.times_s = {0.0f, 2.0f};
  move.values = {glm::vec4(0.0f), glm::vec4(4.0f, 0.0f, 0.0f, 0.0f)};
  scene.nodes[0] = Node{};
  scene.animation = {move};
  expect_point(pose(scene, 0.5f)[0], {0, 0, 0}, {1, 0, 0});
  expect_point(pose(scene, 4.5f)[0], {0, 0, 0}, {1, 0, 0});
  expect_point(pose(scene, -1.5f)[0], {0, 0, 0}, {1, 0, 0});
  scene.animation[0].interpolation = Interpolation::step;
  expect_point(pose(scene, 1.9f)[0], {0, 0, 0}, {0, 0, 0});
}

TEST(Pose, RotationsTurnAtEvenSpeed) {
  Scene scene;
  scene.nodes.resize(1);
  const float half = std::sqrt(0.5f);
  AnimationChannel turn;
  turn.path = AnimationPath::rotation;
  turn.times_s = {1.0f, 4.0f};
  turn.values = {{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, half, half}};
  scene.animation = {turn};
  // A third of a quarter turn about z.
  expect_point(pose(scene, 2.0f)[0], {1, 0, 0}, {std::cos(0.5235988f), 0.5f, 0.0f});
  expect_point(pose(scene, 0.5f)[0], {1, 0, 0}, {1, 0, 0});
}

TEST(Bounds, CoverEveryInstanceAndCountItsTriangles) {
  Scene scene = two_nodes();
  Mesh mesh;
  for (const glm::vec3 p : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
    mesh.vertices.push_back({p, {0, 0, 1}, {1, 0, 0, 1}, {0, 0}});
  mesh.vertices.push_back({{99, 99, 99}, {0, 0, 1}, {1, 0, 0, 1}, {0, 0}});  // not drawn
  mesh.indices = {0, 1, 2};
  mesh.primitives = {{0, 3, 0}};
  scene.meshes = {mesh};
  scene.instances = {{0, 0}, {1, 0}};
  scene.materials.resize(1);
  const Bounds box = bounds_at(scene, 0.0f);
  // The first spans (1, 2, 3) to (1, 3, 2), the second (1, 2, -7) to (1, 5, -9).
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.min[i], (glm::vec3(1, 2, -9)[i]), 1e-5f);
    EXPECT_NEAR(box.max[i], (glm::vec3(1, 5, 3)[i]), 1e-5f);
  }
  EXPECT_EQ(triangle_count(scene), 2u);
  EXPECT_EQ(bounds_at(Scene{}, 0.0f).max, glm::vec3(0.0f));
}

}  // namespace
}  // namespace lueur
