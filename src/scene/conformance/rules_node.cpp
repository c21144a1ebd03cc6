// SPDX-License-Identifier: MIT
// Nodes, scenes and skins.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "scene/conformance/rules.h"

namespace lueur::conformance {
namespace {

constexpr size_t kNoNode = static_cast<size_t>(-1);

// Steps of work that a file can multiply with few bytes (scenes times nodes, joints times depth).
// What is left when they are spent stays unchecked.
constexpr uint64_t kMaxSteps = uint64_t{1} << 24;

struct Forest {
  std::vector<size_t> parents;  // kNoNode for roots
  std::vector<size_t> roots;    // of each node; kNoNode within and below loops
};

// Follows each node up to its root, over nodes not seen before: each is stepped over once.
Forest read_forest(const Json& nodes) {
  Forest forest;
  forest.parents.assign(nodes.size(), kNoNode);
  for (size_t i = 0; i < nodes.size(); ++i)
    for (const Json& child : list(nodes[i], "children"))
      if (const auto index = whole_number(child); index && *index < nodes.size())
        forest.parents[*index] = i;

  forest.roots.assign(nodes.size(), kNoNode);
  std::vector<bool> seen(nodes.size(), false);
  std::vector<size_t> way;
  for (size_t i = 0; i < nodes.size(); ++i) {
    size_t at = i;
    for (way.clear(); !seen[at]; at = forest.parents[at]) {
      seen[at] = true;
      way.push_back(at);
      if (forest.parents[at] == kNoNode) {
        forest.roots[at] = at;
        break;
      }
    }
    for (const size_t node : way) forest.roots[node] = forest.roots[at];
  }
  return forest;
}

// A product of translation, rotation and scale has columns that are at right angles.
bool is_decomposable(const Json& matrix) {
  double m[16];
  for (size_t i = 0; i < 16; ++i) m[i] = matrix[i].is_number() ? matrix[i].get<double>() : 0.0;
  if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0) return false;
  const auto dot = [&](int a, int b) {
    return m[4 * a] * m[4 * b] + m[4 * a + 1] * m[4 * b + 1] + m[4 * a + 2] * m[4 * b + 2];
  };
  constexpr double kTolerance = 1e-3;  // of the cosine: the numbers are printed floats
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    if (!(dot(a, a) > 0.0)) return false;
    if (std::abs(dot(a, b)) > kTolerance * std::sqrt(dot(a, a) * dot(b, b))) return false;
  }
  return true;
}

void check_transform(Asset& asset, const Json& node, const std::string& path) {
  const Json& matrix = list(node, "matrix");
  if (matrix.size() == 16) {
    for (const char* key : {"translation", "rotation", "scale"})
      if (has(node, key))
        return asset.add(path_to(path, "matrix"), std::string("excludes ") + key + " beside it");
    if (!is_decomposable(matrix))
      asset.add(path_to(path, "matrix"), "is not made of translation, rotation and scale");
  }
  const Json& rotation = list(node, "rotation");
  double square = 0.0;
  for (const Json& part : rotation)
    if (part.is_number()) square += part.get<double>() * part.get<double>();
  constexpr double kTolerance = 0.0077;  // what 8-bit quantization leaves
  if (rotation.size() == 4 && std::abs(std::sqrt(square) - 1.0) > kTolerance)
    asset.add(path_to(path, "rotation"), "is not a quaternion of length 1");
}

// Of each mesh: whether it has joints.
std::vector<bool> meshes_with_joints(const Asset& asset) {
  std::vector<bool> result;
  for (const Json& mesh : asset.list_of("meshes"))
    result.push_back(std::ranges::any_of(list(mesh, "primitives"), [](const Json& primitive) {
      return has(member(primitive, "attributes"), "JOINTS_0");
    }));
  return result;
}

void check_mesh_of_node(Asset& asset, const Json& node, const std::vector<bool>& have_joints,
                        const std::string& path) {
  const auto mesh = index_below(node, "mesh", have_joints.size());
  if (!mesh) return;
  const Json& primitives = list(asset.list_of("meshes")[*mesh], "primitives");
  if (primitives.empty()) return;
  if (has(node, "skin") && !have_joints[*mesh])
    asset.add(path, "has a skin, but its mesh has no joints");
  const size_t weights = list(node, "weights").size();
  const size_t targets = list(primitives[0], "targets").size();
  if (weights > 0 && weights != targets)
    asset.add(path_to(path, "weights"), "has " + std::to_string(weights) + " items for " +
                                            std::to_string(targets) + " morph targets");
}

void check_scenes(Asset& asset, const Forest& forest) {
  const Json& scenes = asset.list_of("scenes");
  const Json& nodes = asset.list_of("nodes");
  const Json& skins = asset.list_of("skins");
  uint64_t steps_left = kMaxSteps;
  for (size_t i = 0; i < scenes.size(); ++i) {
    const Json& list_of_roots = list(scenes[i], "nodes");
    std::set<size_t> roots;
    for (size_t k = 0; k < list_of_roots.size(); ++k) {
      const auto index = whole_number(list_of_roots[k]);
      if (!index || *index >= nodes.size()) continue;
      roots.insert(static_cast<size_t>(*index));
      if (forest.parents[*index] != kNoNode)
        asset.add(path_to(path_to("scenes", i), "nodes", k),
                  path_to("nodes", *index) + " is not a root");
    }
    // The joints have to be in the scene that draws the skin.
    if (skins.empty() || steps_left < nodes.size()) continue;
    steps_left -= nodes.size();
    for (size_t k = 0; k < nodes.size(); ++k) {
      const auto skin = index_below(nodes[k], "skin", skins.size());
      if (!skin || !roots.contains(forest.roots[k])) continue;
      const size_t joint_count = list(skins[*skin], "joints").size();
      if (steps_left < joint_count) return;
      steps_left -= joint_count;
      const auto is_outside = [&](const Json& joint) {
        const auto index = whole_number(joint);
        return index && *index < nodes.size() && !roots.contains(forest.roots[*index]);
      };
      if (std::ranges::any_of(list(skins[*skin], "joints"), is_outside))
        asset.add(path_to("nodes", k),
                  "is drawn by " + path_to("scenes", i) + ", which lacks joints of its skin");
    }
  }
}

// Column-major matrices of the fourth row 0 0 0 1, without a stride, one for each joint.
void check_inverse_binds(Asset& asset, const Json& skin, const std::string& path) {
  const auto index = index_below(skin, "inverseBindMatrices", asset.accessors.size());
  if (!index || !asset.accessors[*index].known()) return;
  const std::string at = path_to(path, "inverseBindMatrices");
  const Accessor& accessor = asset.accessors[*index];
  asset.use_accessor(*index, ViewUse::other, at);
  if (!accessor.is("MAT4", kFloat32)) return asset.add(at, "has to be MAT4 of floats");
  const size_t joints = list(skin, "joints").size();
  if (accessor.count < joints)
    asset.add(
        at, std::to_string(accessor.count) + " matrices for " + std::to_string(joints) + " joints");
  const auto& range = asset.accessors.range(*index);
  for (size_t i = 3; range && i < 16; i += 4) {
    const double expected = i == 15 ? 1.0 : 0.0;
    if (range->min[i] != expected || range->max[i] != expected)
      return asset.add(at, "a matrix has a last row that is not 0 0 0 1");
  }
}

bool is_at_or_below(const Forest& forest, size_t node, size_t ancestor) {
  if (forest.roots[node] == kNoNode) return false;  // the way up is a loop
  while (node != ancestor && node != kNoNode) node = forest.parents[node];
  return node == ancestor;
}

void check_joints_of_skin(Asset& asset, const Forest& forest, const Json& skin,
                          uint64_t& steps_left, const std::string& path) {
  const size_t node_count = forest.parents.size();
  const auto skeleton = index_below(skin, "skeleton", node_count);
  size_t root = kNoNode;
  bool is_first = true;
  for (const Json& joint : list(skin, "joints")) {
    const auto index = whole_number(joint);
    if (!index || *index >= node_count) continue;
    if (!is_first && forest.roots[*index] != root)
      return asset.add(path_to(path, "joints"), "have no common root");
    root = forest.roots[*index];
    is_first = false;
    if (!skeleton || steps_left < node_count) continue;
    steps_left -= node_count;
    if (!is_at_or_below(forest, *index, *skeleton))
      return asset.add(path_to(path, "skeleton"),
                       path_to("nodes", *skeleton) + " is not above all joints");
  }
}

}  // namespace

void check_nodes(Asset& asset) {
  const Json& nodes = asset.list_of("nodes");
  const Forest forest = read_forest(nodes);
  const std::vector<bool> have_joints = meshes_with_joints(asset);
  for (size_t i = 0; i < nodes.size(); ++i) {
    const std::string path = path_to("nodes", i);
    check_transform(asset, nodes[i], path);
    check_mesh_of_node(asset, nodes[i], have_joints, path);
  }
  check_scenes(asset, forest);
}

void check_skins(Asset& asset) {
  const Json& skins = asset.list_of("skins");
  if (skins.empty()) return;
  const Forest forest = read_forest(asset.list_of("nodes"));
  uint64_t steps_left = kMaxSteps;
  for (size_t i = 0; i < skins.size(); ++i) {
    const std::string path = path_to("skins", i);
    check_inverse_binds(asset, skins[i], path);
    check_joints_of_skin(asset, forest, skins[i], steps_left, path);
  }
}

}  // namespace lueur::conformance
