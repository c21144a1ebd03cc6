// SPDX-License-Identifier: MIT
// What the vertices hold: unit vectors, colours, joints and weights. Each accessor is read once for
// each thing that it is used as.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "scene/conformance/rules.h"

namespace lueur::conformance {
namespace {

// Lengths may be off by what 8-bit quantization leaves.
constexpr double kLengthTolerance = 0.0068;

// Largest deviation of a sum of float weights that rounding leaves: 2e-7 for each weight, as the
// specification has it.
constexpr double kWeightTolerance = 2e-7;

// What a component stands for after normalization.
double scale_of(const Accessor& accessor) {
  if (!accessor.normalized) return 1.0;
  switch (accessor.component) {
    case kInt8:
      return 1.0 / 127.0;
    case kUint8:
      return 1.0 / 255.0;
    case kInt16:
      return 1.0 / 32767.0;
    case kUint16:
      return 1.0 / 65535.0;
    default:
      return 1.0;
  }
}

void check_unit_vectors(Asset& asset, size_t index, bool is_tangent, const std::string& path) {
  const Accessor& accessor = asset.accessors[index];
  if (accessor.components < (is_tangent ? 4u : 3u)) return;
  const double scale = scale_of(accessor);
  asset.accessors.for_each(index, [&](uint64_t i, const double* v) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * scale;
    const double sign = is_tangent ? std::abs(v[3] * scale) : 1.0;
    if (std::abs(length - 1.0) > kLengthTolerance) {
      asset.add(path, "vector " + std::to_string(i) + " has length " + Json(length).dump() +
                          " instead of 1");
      return false;
    }
    if (sign != 1.0) asset.add(path, "tangent " + std::to_string(i) + " has no sign of 1 or -1");
    return sign == 1.0;
  });
}

void check_colors(Asset& asset, size_t index, const std::string& path) {
  const Accessor& accessor = asset.accessors[index];
  if (accessor.component != kFloat32) return;
  const auto& range = asset.accessors.range(index);
  for (uint32_t i = 0; range && i < accessor.components; ++i)
    if (range->min[i] < 0.0 || range->max[i] > 1.0)
      return asset.add(path, "has colours outside 0 to 1");
}

void check_weights(Asset& asset, const Json& attributes, const std::string& at) {
  // Sum over all sets: weights of a vertex may be spread over several accessors.
  std::vector<double> sums;
  double tolerance = 0.0;
  std::string last;
  for (size_t set = 0; has(attributes, "WEIGHTS_" + std::to_string(set)); ++set) {
    const std::string name = "WEIGHTS_" + std::to_string(set);
    const auto index = index_below(attributes, name, asset.accessors.size());
    if (!index || asset.accessors[*index].components != 4) return;
    const Accessor& accessor = asset.accessors[*index];
    const double scale = scale_of(accessor);
    bool is_negative = false;
    const bool read = asset.accessors.for_each(*index, [&](uint64_t i, const double* weights) {
      if (sums.size() <= i) sums.resize(i + 1, 0.0);
      for (int k = 0; k < 4; ++k) {
        sums[i] += weights[k] * scale;
        is_negative = is_negative || weights[k] < 0.0;
      }
      return true;
    });
    if (!read) return;
    last = path_to(at, name);
    if (is_negative) asset.add(last, "has negative weights");
    tolerance += accessor.component == kFloat32 ? 4 * kWeightTolerance : 0.5 * scale;
  }
  for (size_t i = 0; i < sums.size(); ++i)
    if (std::abs(sums[i] - 1.0) > std::max(tolerance, 1e-6))
      return asset.add(last, "the weights of vertex " + std::to_string(i) + " add up to " +
                                 Json(sums[i]).dump() + " instead of 1");
}

// `joint_count`: of the smallest skin that the mesh is used with; 0 without one.
void check_joints(Asset& asset, const Json& attributes, size_t joint_count, const std::string& at) {
  for (size_t set = 0; has(attributes, "JOINTS_" + std::to_string(set)); ++set) {
    const std::string name = "JOINTS_" + std::to_string(set);
    const auto index = index_below(attributes, name, asset.accessors.size());
    if (!index || joint_count == 0) continue;
    const auto& range = asset.accessors.range(*index);
    for (uint32_t i = 0; range && i < asset.accessors[*index].components; ++i) {
      if (range->max[i] < static_cast<double>(joint_count)) continue;
      asset.add(path_to(at, name), Json(range->max[i]).dump() + " is not below the " +
                                       std::to_string(joint_count) + " joints of the skin");
      break;
    }
  }
}

// The joints of the smallest skin that each mesh is drawn with.
std::map<size_t, size_t> joints_of_meshes(const Asset& asset) {
  std::map<size_t, size_t> joints;
  const Json& skins = asset.list_of("skins");
  for (const Json& node : asset.list_of("nodes")) {
    const auto mesh = index_below(node, "mesh", asset.list_of("meshes").size());
    const auto skin = index_below(node, "skin", skins.size());
    if (!mesh || !skin) continue;
    const size_t count = list(skins[*skin], "joints").size();
    const auto [place, is_new] = joints.emplace(*mesh, count);
    if (!is_new) place->second = std::min(place->second, count);
  }
  return joints;
}

}  // namespace

void check_vertices(Asset& asset) {
  const Json& meshes = asset.list_of("meshes");
  const std::map<size_t, size_t> joints = joints_of_meshes(asset);
  std::set<std::pair<std::string_view, size_t>> done;
  const auto once = [&](const Json& attributes, std::string_view name) {
    const auto index = index_below(attributes, name, asset.accessors.size());
    return index && done.emplace(name, *index).second ? index : std::nullopt;
  };
  for (size_t i = 0; i < meshes.size(); ++i) {
    const Json& primitives = list(meshes[i], "primitives");
    for (size_t k = 0; k < primitives.size(); ++k) {
      const Json& attributes = member(primitives[k], "attributes");
      const std::string at = path_to(path_to(path_to("meshes", i), "primitives", k), "attributes");
      if (const auto normals = once(attributes, "NORMAL"))
        check_unit_vectors(asset, *normals, false, path_to(at, "NORMAL"));
      if (const auto tangents = once(attributes, "TANGENT"))
        check_unit_vectors(asset, *tangents, true, path_to(at, "TANGENT"));
      if (const auto colors = once(attributes, "COLOR_0"))
        check_colors(asset, *colors, path_to(at, "COLOR_0"));
      if (once(attributes, "WEIGHTS_0")) check_weights(asset, attributes, at);
      const auto found = joints.find(i);
      if (found != joints.end()) check_joints(asset, attributes, found->second, at);
    }
  }
}

}  // namespace lueur::conformance
