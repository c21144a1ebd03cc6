// SPDX-License-Identifier: MIT
#include "scene/moving_objects.h"

#include <algorithm>
#include <functional>
#include <map>

#include "scene/deform.h"

namespace lueur {
namespace {

// Whether what the channel sets is ever another than at its first key.
bool changes(const AnimationChannel& channel) {
  return std::ranges::adjacent_find(channel.values, std::not_equal_to<>()) != channel.values.end();
}

// The topmost node that moves, of each node and those above it; kNone where none does.
std::vector<int32_t> topmost_moving(const Scene& scene) {
  std::vector<int32_t> topmost(scene.nodes.size(), kNone);
  for (const AnimationChannel& channel : scene.animation) {
    const auto node = static_cast<size_t>(channel.node);
    // A node with a matrix stays where that has put it.
    if (channel.path != AnimationPath::morph_weight && !scene.nodes[node].matrix &&
        changes(channel))
      topmost[node] = channel.node;
  }
  // Parents stand before their children.
  for (size_t i = 0; i < topmost.size(); ++i)
    if (const int32_t parent = scene.nodes[i].parent; parent != kNone)
      if (const int32_t above = topmost[static_cast<size_t>(parent)]; above != kNone)
        topmost[i] = above;
  return topmost;
}

// By node: whether animation changes the weights of the meshes on it.
std::vector<bool> weighs_targets(const Scene& scene) {
  std::vector<bool> weighs(scene.nodes.size(), false);
  for (const AnimationChannel& channel : scene.animation)
    if (channel.path == AnimationPath::morph_weight && changes(channel))
      weighs[static_cast<size_t>(channel.node)] = true;
  return weighs;
}

}  // namespace

MovingObjects moving_objects(const Scene& scene) {
  const std::vector<int32_t> topmost = topmost_moving(scene);
  const std::vector<bool> weighs = weighs_targets(scene);
  const auto moves = [&](int32_t node) { return topmost[static_cast<size_t>(node)] != kNone; };

  MovingObjects objects;
  std::map<int32_t, int32_t> object_of_node;
  for (const MeshInstance& instance : scene.instances) {
    const bool is_morphed = weighs[static_cast<size_t>(instance.node)] &&
                            !scene.meshes[static_cast<size_t>(instance.mesh)].morph_targets.empty();
    // Joints alone move what has a skin.
    const bool is_moved =
        instance.skin == kNone
            ? moves(instance.node)
            : std::ranges::any_of(scene.skins[static_cast<size_t>(instance.skin)].joints, moves);
    int32_t& object = objects.of_instance.emplace_back(kNone);
    if (!is_moved && !is_morphed) continue;
    const int32_t node = topmost[static_cast<size_t>(instance.node)];
    if (const auto known = object_of_node.find(node);
        node != kNone && known != object_of_node.end())
      object = known->second;
    else if (objects.count < kMostMovingObjects)
      object = objects.count++;
    if (node != kNone) object_of_node.emplace(node, object);
  }
  return objects;
}

std::vector<Bounds> bounds_of_objects(const MovingObjects& objects,
                                      std::span<const Bounds> of_instance) {
  std::vector<std::vector<Bounds>> parts(static_cast<size_t>(objects.count));
  for (size_t i = 0; i < of_instance.size(); ++i)
    if (const int32_t object = objects.of_instance[i]; object != kNone)
      parts[static_cast<size_t>(object)].push_back(of_instance[i]);
  std::vector<Bounds> boxes;
  for (const std::vector<Bounds>& of_object : parts) boxes.push_back(bounds_around(of_object));
  return boxes;
}

}  // namespace lueur
