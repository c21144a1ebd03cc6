// SPDX-License-Identifier: MIT
#include "scene/hold.h"

#include <utility>

namespace lueur {
namespace {

// Copies a node and those above it; gives the copy of each node, or kNone.
std::vector<int32_t> copy_chain(Scene& scene, int32_t node) {
  std::vector<int32_t> chain;
  for (int32_t n = node; n != kNone; n = scene.nodes[static_cast<size_t>(n)].parent)
    chain.push_back(n);
  std::vector<int32_t> copy_of(scene.nodes.size(), kNone);
  for (auto n = chain.rbegin(); n != chain.rend(); ++n) {
    Node copy = scene.nodes[static_cast<size_t>(*n)];
    if (copy.parent != kNone) copy.parent = copy_of[static_cast<size_t>(copy.parent)];
    copy_of[static_cast<size_t>(*n)] = static_cast<int32_t>(scene.nodes.size());
    scene.nodes.push_back(std::move(copy));
  }
  return copy_of;
}

}  // namespace

void hold_camera(Scene& scene, int32_t camera, float time_s) {
  int32_t& node = scene.cameras[static_cast<size_t>(camera)].node;
  Node held;
  held.matrix = pose(scene, time_s)[static_cast<size_t>(node)];
  node = static_cast<int32_t>(scene.nodes.size());
  scene.nodes.push_back(std::move(held));
}

void hold_all_but_camera(Scene& scene, int32_t camera, float time_s) {
  const std::vector<glm::mat4> posed = pose(scene, time_s);
  int32_t& node = scene.cameras[static_cast<size_t>(camera)].node;
  const std::vector<int32_t> copy_of = copy_chain(scene, node);
  node = copy_of[static_cast<size_t>(node)];
  // The other channels stay, without effect on nodes that have a matrix: the longest one is the
  // length of the loop.
  for (AnimationChannel& channel : scene.animation)
    if (const int32_t copy = copy_of[static_cast<size_t>(channel.node)]; copy != kNone)
      channel.node = copy;
  for (size_t i = 0; i < posed.size(); ++i) {
    scene.nodes[i].parent = kNone;
    scene.nodes[i].matrix = posed[i];
  }
}

}  // namespace lueur
