// SPDX-License-Identifier: MIT
#include "scene/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/gltf_accessor.h"

namespace lueur {
namespace {

std::optional<AnimationPath> path_of(const std::string& name) {
  if (name == "translation") return AnimationPath::translation;
  if (name == "rotation") return AnimationPath::rotation;
  if (name == "scale") return AnimationPath::scale;
  if (name == "weights") return AnimationPath::morph_weight;
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

// One value of a channel: of a rotation's key itself, not of its tangents, the unit quaternion.
Result<glm::vec4> read_value(const JsonCursor& sampler, AnimationPath path, const float* value,
                             bool is_key) {
  if (path == AnimationPath::morph_weight) return glm::vec4(value[0], 0.0f, 0.0f, 0.0f);
  if (path != AnimationPath::rotation) return glm::vec4(value[0], value[1], value[2], 0.0f);
  const glm::dvec4 quaternion(value[0], value[1], value[2], value[3]);
  if (!is_key) return glm::vec4(quaternion);
  const double length = glm::length(quaternion);
  if (!(length > 0.0)) return sampler.error("output", "holds a rotation of length 0");
  return glm::vec4(quaternion / length);
}

uint32_t components_of(AnimationPath path) {
  switch (path) {
    case AnimationPath::rotation:
      return 4;
    case AnimationPath::morph_weight:
      return 1;
    case AnimationPath::translation:
    case AnimationPath::scale:
      break;
  }
  return 3;
}

// A sampler's numbers: `columns` values for each of its times, times three for splines.
struct Keys {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;
  std::vector<float> values;
  uint32_t components = 0;  // of one value
  size_t columns = 1;       // values side by side: one for each morph target
};

Result<Keys> read_keys(const GltfFile& file, const JsonCursor& sampler, AnimationPath path,
                       uint64_t& keys_left, Warnings& warnings) {
  Keys keys;
  LUEUR_TRY(interpolation, read_interpolation(sampler));
  keys.interpolation = interpolation;
  keys.components = components_of(path);
  // Spend before reading: many channels may name one large accessor.
  LUEUR_TRY(input, sampler.required_index("input", file.size_of("accessors"), "accessors"));
  LUEUR_TRY(input_shape, accessor_shape(file, input));
  if (!input_shape.has_data) {
    warnings.add("animation without key frames is left out");
    return keys;
  }
  LUEUR_TRY(output, sampler.required_index("output", file.size_of("accessors"), "accessors"));
  LUEUR_TRY(output_shape, accessor_shape(file, output));
  const uint64_t needed = std::max(input_shape.count, output_shape.count);
  if (needed > keys_left)
    return sampler.error("the animation has more than " + std::to_string(file.limits().vertices) +
                         " key frames; resample it");
  keys_left -= needed;
  LUEUR_TRY(times, read_finite(file, sampler, "input", 1));
  LUEUR_TRY(values, read_finite(file, sampler, "output", keys.components));
  for (size_t i = 0; i < times.size(); ++i)
    if (times[i] < 0.0f || (i > 0 && times[i] < times[i - 1]))
      return sampler.error("input", "the times have to be 0 or more and ascend");

  const size_t floats_a_key =
      keys.components * size_t{keys.interpolation == Interpolation::cubic_spline ? 3u : 1u};
  if (path == AnimationPath::morph_weight && !times.empty())
    keys.columns = std::max<size_t>(values.size() / (times.size() * floats_a_key), 1);
  if (values.size() != times.size() * floats_a_key * keys.columns)
    return sampler.error("output", "does not fit the " + std::to_string(times.size()) +
                                       " times of the input; re-export the file");
  keys.times_s = std::move(times);
  keys.values = std::move(values);
  return keys;
}

// Takes column `column` of the keys over; of several keys at one time the last counts.
Result<void> take_column(const JsonCursor& sampler, const Keys& keys, size_t column,
                         AnimationChannel& channel) {
  channel.interpolation = keys.interpolation;
  const size_t parts = keys.interpolation == Interpolation::cubic_spline ? 3 : 1;
  for (size_t i = 0; i < keys.times_s.size(); ++i) {
    const float time_s = keys.times_s[i];
    if (!channel.times_s.empty() && time_s == channel.times_s.back()) {
      channel.times_s.pop_back();
      channel.values.resize(channel.values.size() - parts);
    }
    channel.times_s.push_back(time_s);
    for (size_t part = 0; part < parts; ++part) {
      const size_t place = ((i * parts + part) * keys.columns + column) * keys.components;
      LUEUR_TRY(value, read_value(sampler, channel.path, keys.values.data() + place,
                                  parts == 1 || part == 1));
      channel.values.push_back(value);
    }
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
  if (path != AnimationPath::morph_weight && tree.nodes[static_cast<size_t>(node)].matrix) {
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
    LUEUR_TRY(keys, read_keys(file, sampler, channel->path, keys_left, warnings));
    for (size_t column = 0; column < keys.columns; ++column) {
      AnimationChannel one = *channel;
      one.morph_target = static_cast<uint32_t>(column);
      LUEUR_TRY_VOID(take_column(sampler, keys, column, one));
      if (!one.times_s.empty()) result.push_back(std::move(one));
    }
  }
  return result;
}

}  // namespace lueur
