// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <utility>

#include "base/check.h"
#include "scene/gltf_export_parts.h"

namespace lueur {
namespace {

int add_times(GlbWriter& glb, const std::vector<float>& times_s) {
  const int input = glb.add_array(times_s, kGltfFloat, "SCALAR");
  glb.json()["accessors"][input]["min"] = {times_s.front()};
  glb.json()["accessors"][input]["max"] = {times_s.back()};
  return input;
}

OrderedJson sampler_json(const AnimationChannel& channel, int input, int output) {
  const char* name = channel.interpolation == Interpolation::step     ? "STEP"
                     : channel.interpolation == Interpolation::linear ? "LINEAR"
                                                                      : "CUBICSPLINE";
  return {{"input", input}, {"output", output}, {"interpolation", name}};
}

// glTF keeps the weights of all targets of a node in one sampler: it is made of the node's
// channels, which the loader has taken apart.
void add_morph_animation(GlbWriter& glb, const Scene& scene, OrderedJson& samplers,
                         OrderedJson& channels) {
  std::map<int32_t, std::vector<const AnimationChannel*>> by_node;
  for (const AnimationChannel& channel : scene.animation)
    if (channel.path == AnimationPath::morph_weight) by_node[channel.node].push_back(&channel);
  for (auto& [node, of_node] : by_node) {
    std::sort(of_node.begin(), of_node.end(),
              [](const auto* a, const auto* b) { return a->morph_target < b->morph_target; });
    const AnimationChannel& first = *of_node.front();
    std::vector<float> values;
    for (size_t i = 0; i < first.values.size(); ++i)
      for (const AnimationChannel* channel : of_node) {
        LUEUR_CHECK_OP(channel->values.size(), ==, first.values.size());
        values.push_back(channel->values[i].x);
      }
    const int output = glb.add_array(values, kGltfFloat, "SCALAR");
    channels.push_back(
        {{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", "weights"}}}});
    samplers.push_back(sampler_json(first, add_times(glb, first.times_s), output));
  }
}

}  // namespace

void export_animation(GlbWriter& glb, const Scene& scene) {
  if (scene.animation.empty()) return;
  OrderedJson samplers = OrderedJson::array(), channels = OrderedJson::array();
  for (const AnimationChannel& channel : scene.animation) {
    if (channel.path == AnimationPath::morph_weight) continue;
    const bool is_rotation = channel.path == AnimationPath::rotation;
    std::vector<float> values;
    for (const glm::vec4& v : channel.values)
      for (int c = 0; c < (is_rotation ? 4 : 3); ++c) values.push_back(v[c]);
    const int output = glb.add_accessor(glb.add_view(GlbWriter::bytes_of(values)), 0, kGltfFloat,
                                        is_rotation ? "VEC4" : "VEC3", channel.values.size());
    const char* path = is_rotation                                  ? "rotation"
                       : channel.path == AnimationPath::translation ? "translation"
                                                                    : "scale";
    channels.push_back(
        {{"sampler", samplers.size()}, {"target", {{"node", channel.node}, {"path", path}}}});
    samplers.push_back(sampler_json(channel, add_times(glb, channel.times_s), output));
  }
  add_morph_animation(glb, scene, samplers, channels);
  if (!channels.empty())
    glb.add_to("animations",
               {{"samplers", std::move(samplers)}, {"channels", std::move(channels)}});
}

}  // namespace lueur
