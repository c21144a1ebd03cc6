// SPDX-License-Identifier: MIT
#include "scene/gltf_animation.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/gltf_accessor.h"

namespace lueur {
namespace {

enum class Interpolation { linear, step, cubic_spline };

std::optional<AnimationPath> path_of(const std::string& name) {
  if (name == "translation") return AnimationPath::translation;
  if (name == "rotation") return AnimationPath::rotation;
  if (name == "scale") return AnimationPath::scale;
  return std::nullopt;
}

Result<Interpolation> read_interpolation(const JsonCursor& sampler) {
  LUEUR_TRY(name, sampler.text("interpolation", "LINEAR"));
  if (name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  return sampler.error("interpolation", in_quotes(name) + " is not LINEAR, STEP or CUBICSPLINE");
}

Result<std::vector<float>> read_finite(const GltfFile& file, const JsonCursor& sampler,
                                       const char* key, uint32_t components) {
  LUEUR_TRY(accessor, sampler.required_index(key, file.size_of("accessors"), "accessors"));
  LUEUR_TRY(shape, accessor_shape(file, accessor));
  if (shape.components != components)
    return sampler.error(key, "has to have " + std::to_string(components) +
                                  (components == 1 ? " component" : " components"));
  LUEUR_TRY(values, read_floats(file, accessor));
  for (const float value : values)
    if (!std::isfinite(value)) return sampler.error(key, "holds a value that is not finite");
  return std::move(values);
}

Result<glm::vec4> key_value(const JsonCursor& sampler, AnimationPath path, const float* value) {
  if (path != AnimationPath::rotation) return glm::vec4(value[0], value[1], value[2], 0.0f);
  const glm::dvec4 quaternion(value[0], value[1], value[2], value[3]);
  const double length = glm::length(quaternion);
  if (!(length > 0.0)) return sampler.error("output", "holds a rotation of length 0");
  return glm::vec4(quaternion / length);
}

// Appends the key frames of `sampler`; of several at one time the last counts.
Result<void> read_keys(const GltfFile& file, const JsonCursor& sampler, AnimationChannel& channel,
                       uint64_t& keys_left, Warnings& warnings) {
  LUEUR_TRY(interpolation, read_interpolation(sampler));
  channel.step = interpolation == Interpolation::step;
  const bool cubic = interpolation == Interpolation::cubic_spline;
  if (cubic) warnings.add("cubic spline animation is reduced to straight lines between its keys");

  const uint32_t components = channel.path == AnimationPath::rotation ? 4 : 3;
  // Spend before reading: many channels may name one large accessor.
  LUEUR_TRY(input, sampler.required_index("input", file.size_of("accessors"), "accessors"));
  LUEUR_TRY(input_shape, accessor_shape(file, input));
  if (input_shape.count > keys_left)
    return sampler.error("the animation has more than " + std::to_string(file.limits().vertices) +
                         " key frames; resample it");
  keys_left -= input_shape.count;
  LUEUR_TRY(times, read_finite(file, sampler, "input", 1));
  LUEUR_TRY(values, read_finite(file, sampler, "output", components));
  const size_t values_per_key = cubic ? 3 : 1;  // in-tangent, value, out-tangent
  if (values.size() != times.size() * values_per_key * components)
    return sampler.error("output", "does not fit the " + std::to_string(times.size()) +
                                       " times of the input; re-export the file");
  for (size_t i = 0; i < times.size(); ++i) {
    const size_t place = (i * values_per_key + (cubic ? 1 : 0)) * components;
    LUEUR_TRY(value, key_value(sampler, channel.path, values.data() + place));
    if (times[i] < 0.0f || (i > 0 && times[i] < times[i - 1]))
      return sampler.error("input", "the times have to be 0 or more and ascend");
    if (!channel.times_s.empty() && times[i] == channel.times_s.back()) {
      channel.values.back() = value;
      continue;
    }
    channel.times_s.push_back(times[i]);
    channel.values.push_back(value);
  }
  return {};
}

// What one channel drives; none if that is not in the scene or cannot be drawn.
Result<std::optional<AnimationChannel>> read_target(const JsonCursor& at, const NodeTree& tree,
                                                    Warnings& warnings) {
  const std::optional<AnimationChannel> nothing;
  LUEUR_TRY(target, at.object("target"));
  LUEUR_TRY(file_node, target.index("node", tree.node_of_file_node.size(), "nodes"));
  LUEUR_TRY(path_name, target.text("path", ""));
  const std::optional<AnimationPath> path = path_of(path_name);
  if (!path) {
    warnings.add("animation of " + in_quotes(path_name) + " is not supported: left out");
    return nothing;
  }
  if (file_node == kNone) return nothing;
  const int32_t node = tree.node_of_file_node[static_cast<size_t>(file_node)];
  if (node == kNone) return nothing;
  if (tree.nodes[static_cast<size_t>(node)].matrix) {
    warnings.add("animation of " + in_quotes(path_name) + " is not supported: left out");
    return nothing;
  }
  AnimationChannel channel;
  channel.node = node;
  channel.path = *path;
  return std::optional(channel);
}

}  // namespace

Result<std::vector<AnimationChannel>> read_animation(const GltfFile& file, const NodeTree& tree,
                                                     Warnings& warnings) {
  std::vector<AnimationChannel> result;
  const JsonCursor top = file.root();
  LUEUR_TRY(animations, top.array("animations"));
  if (animations.size() == 0) return result;
  if (animations.size() > 1)
    warnings.add("only the first of " + std::to_string(animations.size()) +
                 " animations is played");
  LUEUR_TRY(animation, animations.element(0));
  LUEUR_TRY(samplers, animation.array("samplers"));
  LUEUR_TRY(channels, animation.array("channels"));

  uint64_t keys_left = file.limits().vertices;
  for (size_t i = 0; i < channels.size(); ++i) {
    LUEUR_TRY(at, channels.element(i));
    LUEUR_TRY(channel, read_target(at, tree, warnings));
    if (!channel) continue;
    LUEUR_TRY(index, at.required_index("sampler", samplers.size(), "samplers"));
    LUEUR_TRY(sampler, samplers.element(static_cast<size_t>(index)));
    LUEUR_TRY_VOID(read_keys(file, sampler, *channel, keys_left, warnings));
    result.push_back(std::move(*channel));
  }
  return result;
}

}  // namespace lueur
