// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <unordered_map>

namespace lueur {
namespace {

// Time within one loop of the longest channel.
float looped_time(const std::vector<AnimationChannel>& animation, float time_s) {
  float duration_s = 0.0f;
  for (const AnimationChannel& channel : animation)
    if (!channel.times_s.empty()) duration_s = std::max(duration_s, channel.times_s.back());
  if (!(duration_s > 0.0f) || !std::isfinite(time_s)) return 0.0f;
  const float rest_s = std::fmod(time_s, duration_s);
  return rest_s < 0.0f ? rest_s + duration_s : rest_s;
}

glm::quat as_quaternion(const glm::vec4& xyzw) {
  return {xyzw.w, xyzw.x, xyzw.y, xyzw.z};
}

// glTF 2.0, appendix C: the cubic Hermite spline between two keys `span_s` apart.
glm::vec4 hermite(const glm::vec4& from, const glm::vec4& slope_out, const glm::vec4& slope_in,
                  const glm::vec4& to, float t, float span_s) {
  const float t2 = t * t, t3 = t2 * t;
  return (2.0f * t3 - 3.0f * t2 + 1.0f) * from + (t3 - 2.0f * t2 + t) * span_s * slope_out +
         (3.0f * t2 - 2.0f * t3) * to + (t3 - t2) * span_s * slope_in;
}

// The channel's value; before the first and after the last key frame that one's.
glm::vec4 sample(const AnimationChannel& channel, float time_s) {
  const bool cubic = channel.interpolation == Interpolation::cubic_spline;
  const auto value = [&](size_t key) -> const glm::vec4& {
    return channel.values[cubic ? 3 * key + 1 : key];
  };
  const auto after = std::upper_bound(channel.times_s.begin(), channel.times_s.end(), time_s);
  if (after == channel.times_s.begin()) return value(0);
  const size_t next = static_cast<size_t>(after - channel.times_s.begin());
  const glm::vec4& from = value(next - 1);
  if (after == channel.times_s.end() || channel.interpolation == Interpolation::step) return from;
  const glm::vec4& to = value(next);
  const float start_s = channel.times_s[next - 1];
  const float span_s = channel.times_s[next] - start_s;
  const float blend = (time_s - start_s) / span_s;
  if (cubic)
    return hermite(from, channel.values[3 * next - 1], channel.values[3 * next], to, blend, span_s);
  if (channel.path != AnimationPath::rotation) return glm::mix(from, to, blend);
  const glm::quat rotation = glm::slerp(as_quaternion(from), as_quaternion(to), blend);
  return {rotation.x, rotation.y, rotation.z, rotation.w};
}

void apply(const AnimationChannel& channel, float time_s, Node& node) {
  const glm::vec4 value = sample(channel, time_s);
  switch (channel.path) {
    case AnimationPath::translation:
      node.translation = glm::vec3(value);
      break;
    case AnimationPath::rotation:
      // A spline may pass through 0, where there is no rotation.
      if (glm::dot(value, value) > 0.0f) node.rotation = glm::normalize(as_quaternion(value));
      break;
    case AnimationPath::scale:
      node.scale = glm::vec3(value);
      break;
    case AnimationPath::morph_weight:
      break;  // moves no node: see morph_weights()
  }
}

glm::mat4 local_transform(const Node& node) {
  if (node.matrix) return *node.matrix;
  const glm::mat4 moved = glm::translate(glm::mat4(1.0f), node.translation);
  return glm::scale(moved * glm::mat4_cast(node.rotation), node.scale);
}

}  // namespace

bool is_finite(const glm::mat4& m) {
  const float* values = glm::value_ptr(m);
  return std::all_of(values, values + 16, [](float value) { return std::isfinite(value); });
}

glm::mat4 world_from_camera(const glm::mat4& world_from_node) {
  glm::mat4 world_from_view(1.0f);
  for (int axis = 0; axis < 3; ++axis)
    world_from_view[axis] = glm::vec4(glm::normalize(glm::vec3(world_from_node[axis])), 0.0f);
  world_from_view[3] = world_from_node[3];
  return world_from_view;
}

std::vector<glm::mat4> pose(const Scene& scene, float time_s) {
  std::vector<glm::mat4> world_from_node(scene.nodes.size());
  const auto place = [&](size_t i, const Node& node) {
    const glm::mat4 local = local_transform(node);
    world_from_node[i] =
        node.parent == kNone ? local : world_from_node[static_cast<size_t>(node.parent)] * local;
  };
  if (scene.animation.empty()) {
    for (size_t i = 0; i < scene.nodes.size(); ++i) place(i, scene.nodes[i]);
    return world_from_node;
  }

  // Copy the nodes and move the copies: the scene keeps its rest pose.
  std::vector<Node> nodes = scene.nodes;
  const float loop_s = looped_time(scene.animation, time_s);
  for (const AnimationChannel& channel : scene.animation)
    if (!channel.times_s.empty()) apply(channel, loop_s, nodes[static_cast<size_t>(channel.node)]);
  for (size_t i = 0; i < nodes.size(); ++i) place(i, nodes[i]);
  // Finite keys still multiply to infinity; at rest the loader has made sure that none do.
  if (!std::ranges::all_of(world_from_node, is_finite))
    for (size_t i = 0; i < nodes.size(); ++i) place(i, scene.nodes[i]);
  return world_from_node;
}

std::vector<std::vector<float>> morph_weights(const Scene& scene, float time_s) {
  std::vector<std::vector<float>> weights;
  std::unordered_multimap<int32_t, size_t> instances_of_node;
  for (const MeshInstance& instance : scene.instances) {
    const size_t targets = scene.meshes[static_cast<size_t>(instance.mesh)].morph_targets.size();
    if (targets > 0) instances_of_node.emplace(instance.node, weights.size());
    weights.push_back(instance.morph_weights);
    weights.back().resize(targets, 0.0f);
  }
  const float loop_s = looped_time(scene.animation, time_s);
  for (const AnimationChannel& channel : scene.animation) {
    if (channel.path != AnimationPath::morph_weight || channel.times_s.empty()) continue;
    const auto [first, last] = instances_of_node.equal_range(channel.node);
    for (auto moved = first; moved != last; ++moved)
      if (std::vector<float>& of_instance = weights[moved->second];
          channel.morph_target < of_instance.size())
        of_instance[channel.morph_target] = sample(channel, loop_s).x;
  }
  return weights;
}

uint64_t triangle_count(const Scene& scene) {
  uint64_t count = 0;
  for (const MeshInstance& instance : scene.instances)
    for (const Primitive& primitive : scene.meshes[static_cast<size_t>(instance.mesh)].primitives)
      count += primitive.index_count / 3;
  return count;
}

}  // namespace lueur
