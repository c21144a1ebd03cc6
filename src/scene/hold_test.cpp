// SPDX-License-Identifier: MIT
#include "scene/hold.h"

#include <gtest/gtest.h>

namespace lueur {
namespace {

constexpr float kHeld_s = 0.25f;
constexpr float kLater_s = 0.75f;

AnimationChannel sliding(int32_t node, float metres_in_a_second) {
  AnimationChannel channel;
  channel.node = node;
  channel.times_s = {0.0f, 1.0f};
  channel.values = {glm::vec4(0.0f), glm::vec4(metres_in_a_second, 0.0f, 0.0f, 0.0f)};
  return channel;
}

// A cart (0) carries a camera (1) that slides on it, and a lamp (2) that does not; a ball (3) rolls
// by itself.
Scene cart_with_camera() {
  Scene scene;
  scene.nodes.resize(4);
  scene.nodes[1].parent = scene.nodes[2].parent = 0;
  scene.nodes[2].translation = {0.0f, 2.0f, 0.0f};
  scene.cameras.push_back({.name = "on the cart", .node = 1});
  scene.animation = {sliding(0, 1.0f), sliding(1, 10.0f), sliding(3, 100.0f)};
  return scene;
}

glm::vec3 camera_at(const Scene& scene, float time_s) {
  return pose(scene, time_s)[static_cast<size_t>(scene.cameras[0].node)][3];
}
glm::vec3 node_at(const Scene& scene, size_t node, float time_s) {
  return pose(scene, time_s)[node][3];
}

TEST(Hold, Camera) {
  const Scene moving = cart_with_camera();
  Scene held = moving;
  hold_camera(held, 0, kHeld_s);
  EXPECT_EQ(camera_at(held, kLater_s), camera_at(moving, kHeld_s));
  for (const size_t node : {0u, 2u, 3u})
    EXPECT_EQ(node_at(held, node, kLater_s), node_at(moving, node, kLater_s)) << node;
}

TEST(Hold, AllButCamera) {
  const Scene moving = cart_with_camera();
  Scene held = moving;
  hold_all_but_camera(held, 0, kHeld_s);
  for (const float time_s : {0.0f, kHeld_s, kLater_s}) {
    EXPECT_EQ(camera_at(held, time_s), camera_at(moving, time_s));
    for (const size_t node : {0u, 2u, 3u})
      EXPECT_EQ(node_at(held, node, time_s), node_at(moving, node, kHeld_s)) << node;
  }
}

// Channels of what stands still keep the loop as long as it was.
TEST(Hold, LoopKeepsItsLength) {
  Scene scene = cart_with_camera();
  scene.animation[2].times_s = {0.0f, 3.0f};
  const glm::vec3 before = camera_at(scene, 3.5f);
  hold_all_but_camera(scene, 0, kHeld_s);
  EXPECT_EQ(camera_at(scene, 3.5f), before);
  EXPECT_NE(camera_at(scene, 2.5f), before);
}

}  // namespace
}  // namespace lueur
