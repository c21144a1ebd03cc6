// SPDX-License-Identifier: MIT
// Animations: what channels move, and the times and values of their samplers.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "scene/conformance/rules.h"

namespace lueur::conformance {
namespace {

bool is_path(std::string_view path) {
  return path == "translation" || path == "rotation" || path == "scale" || path == "weights";
}

// Morph targets of the mesh on a node; none without a mesh.
size_t target_count(const Asset& asset, const Json& node) {
  const Json& meshes = asset.list_of("meshes");
  const auto mesh = index_below(node, "mesh", meshes.size());
  if (!mesh) return 0;
  const Json& primitives = list(meshes[*mesh], "primitives");
  return primitives.empty() ? 0 : list(primitives[0], "targets").size();
}

void check_times(Asset& asset, size_t index, const std::string& path) {
  double last = -1.0;
  asset.accessors.for_each(index, [&](uint64_t i, const double* time) {
    const bool negative = *time < 0.0;
    const bool descends = i > 0 && *time <= last;
    last = *time;
    if (negative) asset.add(path, "time " + std::to_string(i) + " is negative");
    if (!negative && descends)
      asset.add(path, "time " + std::to_string(i) + " is not after the one before");
    return !negative && !descends;
  });
}

void check_sampler(Asset& asset, const Json& sampler, const std::string& path) {
  const size_t count = asset.accessors.size();
  for (const char* key : {"input", "output"})
    if (const auto index = index_below(sampler, key, count))
      asset.use_accessor(*index, ViewUse::other, path_to(path, key));
  const auto input = index_below(sampler, "input", count);
  if (!input || !asset.accessors[*input].known()) return;
  const std::string at = path_to(path, "input");
  const Accessor& times = asset.accessors[*input];
  if (!times.is("SCALAR", kFloat32)) return asset.add(at, "times have to be SCALAR floats");
  if (!times.has_bounds) asset.add(at, "the accessor of times needs min and max");
  if (text(sampler, "interpolation") == "CUBICSPLINE" && times.count < 2)
    asset.add(at, "a cubic spline needs 2 times or more");
  check_times(asset, *input, at);
}

// Rotations are unit quaternions; of the three of a cubic spline's key, the middle one.
void check_rotations(Asset& asset, size_t index, bool is_cubic, const std::string& path) {
  const Accessor& accessor = asset.accessors[index];
  double scale = 1.0;
  if (accessor.component == kInt8 || accessor.component == kUint8) scale = 1.0 / 127.0;
  if (accessor.component == kInt16 || accessor.component == kUint16) scale = 1.0 / 32767.0;
  asset.accessors.for_each(index, [&](uint64_t i, const double* q) {
    if (is_cubic && i % 3 != 1) return true;
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) * scale;
    constexpr double kTolerance = 0.0077;  // what 8-bit quantization leaves
    if (std::abs(length - 1.0) <= kTolerance) return true;
    asset.add(path, "rotation " + std::to_string(i) + " has length " + Json(length).dump() +
                        " instead of 1");
    return false;
  });
}

void check_output(Asset& asset, const Json& sampler, std::string_view target, size_t morph_targets,
                  const std::string& path) {
  const size_t count = asset.accessors.size();
  const auto input = index_below(sampler, "input", count);
  const auto output = index_below(sampler, "output", count);
  if (!input || !output) return;
  const Accessor& times = asset.accessors[*input];
  const Accessor& values = asset.accessors[*output];
  if (!times.known() || !values.known()) return;

  const bool is_cubic = text(sampler, "interpolation") == "CUBICSPLINE";
  const std::string_view type = target == "rotation"  ? "VEC4"
                                : target == "weights" ? "SCALAR"
                                                      : "VEC3";
  const bool may_be_integer = target == "rotation" || target == "weights";
  const bool kind_fits = values.component == kFloat32 || (may_be_integer && values.normalized);
  if (values.type != type || !kind_fits)
    return asset.add(path, "the output is no " + std::string(type) + " of " +
                               (may_be_integer ? "floats or normalized integers" : "floats"));
  const uint64_t values_per_key =
      (is_cubic ? 3u : 1u) * (target == "weights" ? std::max<size_t>(morph_targets, 1) : 1);
  if (values.count != times.count * values_per_key)
    asset.add(path, "the output has " + std::to_string(values.count) + " elements instead of " +
                        std::to_string(times.count * values_per_key));
  if (target == "rotation") check_rotations(asset, *output, is_cubic, path);
}

void check_pointer(Asset& asset, const Json& target, const std::string& path) {
  const Json& extension = member(target, {"extensions", "KHR_animation_pointer"});
  if (!extension.is_object()) return;
  const std::string at = path + ".extensions.KHR_animation_pointer";
  if (has(target, "node")) asset.add(at, "excludes a node of the target");
  if (text(target, "path") != "pointer")
    asset.add(at, "needs the path 'pointer', not " + in_quotes(text(target, "path")));
  const std::string_view pointer = text(extension, "pointer");
  if (has(extension, "pointer") && !pointer.empty() && pointer[0] != '/')
    asset.add(path_to(at, "pointer"), in_quotes(pointer) + " is not a JSON pointer");
}

class AnimationCheck {
 public:
  AnimationCheck(Asset& asset, const Json& animation, std::string path)
      : asset_(&asset), animation_(&animation), path_(std::move(path)) {}

  void check() {
    const Json& samplers = list(*animation_, "samplers");
    const Json& channels = list(*animation_, "channels");
    for (size_t i = 0; i < samplers.size(); ++i)
      check_sampler(*asset_, samplers[i], path_to(path_, "samplers", i));
    for (size_t i = 0; i < channels.size(); ++i)
      check_channel(channels[i], path_to(path_, "channels", i));
  }

 private:
  void check_channel(const Json& channel, const std::string& path) {
    const Json& nodes = asset_->list_of("nodes");
    const Json& samplers = list(*animation_, "samplers");
    const Json& target = member(channel, "target");
    const std::string at = path_to(path, "target");
    check_pointer(*asset_, target, at);
    const std::string_view property = text(target, "path");
    const auto node = index_below(target, "node", nodes.size());
    if (node) {
      const auto [first, is_new] = targets_.emplace(std::pair(*node, property), at);
      if (!is_new) asset_->add(at, "is that of " + first->second + ", too");
      if (is_path(property) && property != "weights" && has(nodes[*node], "matrix"))
        asset_->add(at, path_to("nodes", *node) + " has a matrix, which cannot be animated");
      if (property == "weights" && target_count(*asset_, nodes[*node]) == 0)
        asset_->add(at, path_to("nodes", *node) + " has no morph targets to animate");
    }
    if (has(channel, "sampler") && !index_below(channel, "sampler", samplers.size()))
      asset_->add(path_to(path, "sampler"),
                  "is not below the " + std::to_string(samplers.size()) + " samplers");
    const auto sampler = index_below(channel, "sampler", samplers.size());
    if (sampler && is_path(property))
      check_output(*asset_, samplers[*sampler], property,
                   node ? target_count(*asset_, nodes[*node]) : 0, path_to(path, "sampler"));
  }

  Asset* asset_;
  const Json* animation_;
  std::string path_;
  std::map<std::pair<size_t, std::string_view>, std::string> targets_;
};

}  // namespace

void check_animations(Asset& asset) {
  const Json& animations = asset.list_of("animations");
  for (size_t i = 0; i < animations.size(); ++i)
    AnimationCheck(asset, animations[i], path_to("animations", i)).check();
}

}  // namespace lueur::conformance
