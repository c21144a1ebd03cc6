// SPDX-License-Identifier: MIT
#include "scene/gltf_node.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <utility>

#include "base/try.h"

namespace lueur {
namespace {

// The file's nodes as a forest: each has at most one parent.
struct Forest {
  std::vector<std::vector<int32_t>> children;
  std::vector<int32_t> parents;
};

Result<Forest> read_forest(const JsonCursor& nodes) {
  Forest forest;
  forest.children.resize(nodes.size());
  forest.parents.assign(nodes.size(), kNone);
  for (size_t i = 0; i < nodes.size(); ++i) {
    LUEUR_TRY(node, nodes.element(i));
    LUEUR_TRY(children, node.indices("children", nodes.size(), "nodes"));
    for (const int32_t child : children) {
      int32_t& parent = forest.parents[static_cast<size_t>(child)];
      if (parent != kNone)
        return node.error("children", "node " + std::to_string(child) +
                                          " already is a child of node " + std::to_string(parent) +
                                          "; nodes have to form a tree, re-export the file");
      parent = static_cast<int32_t>(i);
    }
    forest.children[i] = std::move(children);
  }
  return forest;
}

// Lists all nodes below `roots` with parents first. No node can come up twice: each has one parent.
std::vector<int32_t> parents_first(const Forest& forest, const std::vector<int32_t>& roots) {
  std::vector<int32_t> order = roots;
  for (size_t i = 0; i < order.size(); ++i) {
    const std::vector<int32_t>& children = forest.children[static_cast<size_t>(order[i])];
    order.insert(order.end(), children.begin(), children.end());
  }
  return order;
}

std::vector<int32_t> parentless(const Forest& forest) {
  std::vector<int32_t> roots;
  for (size_t i = 0; i < forest.parents.size(); ++i)
    if (forest.parents[i] == kNone) roots.push_back(static_cast<int32_t>(i));
  return roots;
}

// What no root leads to lies on or below a cycle.
Result<void> refuse_cycles(const JsonCursor& nodes, const Forest& forest) {
  const std::vector<int32_t> reached = parents_first(forest, parentless(forest));
  if (reached.size() == nodes.size()) return {};
  std::vector<bool> is_reached(nodes.size(), false);
  for (const int32_t node : reached) is_reached[static_cast<size_t>(node)] = true;
  const auto lost = std::find(is_reached.begin(), is_reached.end(), false) - is_reached.begin();
  return nodes.error("node " + std::to_string(lost) +
                     " is its own ancestor, or below one that is; re-export the file");
}

Result<std::vector<int32_t>> read_roots(const GltfFile& file, const Forest& forest) {
  const JsonCursor top = file.root();
  LUEUR_TRY(scenes, top.array("scenes"));
  if (scenes.size() == 0) return parentless(forest);
  LUEUR_TRY(chosen, top.index("scene", scenes.size(), "scenes"));
  LUEUR_TRY(scene, scenes.element(static_cast<size_t>(std::max(chosen, 0))));
  LUEUR_TRY(roots, scene.indices("nodes", forest.parents.size(), "nodes"));
  std::vector<bool> seen(forest.parents.size(), false);
  for (const int32_t root : roots) {
    const int32_t parent = forest.parents[static_cast<size_t>(root)];
    if (parent != kNone || seen[static_cast<size_t>(root)])
      return scene.error("nodes", "node " + std::to_string(root) +
                                      (parent != kNone ? " is not a root" : " is listed twice") +
                                      "; re-export the file");
    seen[static_cast<size_t>(root)] = true;
  }
  return std::move(roots);
}

Result<void> read_transform(const JsonCursor& at, Node& node) {
  std::array<float, 16> matrix{};
  LUEUR_TRY(has_matrix, at.numbers("matrix", matrix));
  if (has_matrix) {
    const glm::mat4 m = glm::make_mat4(matrix.data());
    if (m[0][3] != 0.0f || m[1][3] != 0.0f || m[2][3] != 0.0f || m[3][3] != 1.0f)
      return at.error("matrix", "the last row has to be 0 0 0 1; re-export the file");
    set_transform(node, m);
    return {};
  }
  std::array<float, 3> translation{}, scale{1.0f, 1.0f, 1.0f};
  std::array<float, 4> rotation{0.0f, 0.0f, 0.0f, 1.0f};
  LUEUR_TRY_VOID(at.numbers("translation", translation));
  LUEUR_TRY_VOID(at.numbers("rotation", rotation));
  LUEUR_TRY_VOID(at.numbers("scale", scale));
  node.translation = glm::make_vec3(translation.data());
  node.scale = glm::make_vec3(scale.data());
  const glm::dquat quaternion(rotation[3], rotation[0], rotation[1], rotation[2]);
  const double length = glm::length(quaternion);
  if (!(length > 0.0)) return at.error("rotation", "is not a unit quaternion; re-export the file");
  node.rotation = glm::quat(quaternion / length);
  return {};
}

Result<Camera> read_camera(const JsonCursor& at, int32_t node) {
  constexpr float kMaxFov = 3.1f;
  Camera camera;
  camera.node = node;
  LUEUR_TRY(name, at.text("name", ""));
  camera.name = name;
  LUEUR_TRY(perspective, at.object("perspective"));
  LUEUR_TRY(fov, perspective.number("yfov", 0.0f));
  LUEUR_TRY(near, perspective.number("znear", 0.0f));
  if (!(fov > 0.0f && fov < kMaxFov))
    return perspective.error("yfov", "has to be more than 0 and less than 3.1 radians");
  if (!(near > 0.0f)) return perspective.error("znear", "has to be more than 0");
  camera.vertical_fov_rad = fov;
  camera.near_m = near;
  return camera;
}

Result<Light> read_light(const JsonCursor& at, int32_t node, Warnings& warnings) {
  constexpr float kRightAngle = 1.5707964f, kMaxIntensity = 1e12f;
  Light light;
  light.node = node;
  LUEUR_TRY(name, at.text("name", ""));
  light.name = name;
  LUEUR_TRY(type, at.text("type", ""));
  if (type == "directional")
    light.kind = LightKind::directional;
  else if (type == "spot")
    light.kind = LightKind::spot;
  else if (type != "point")
    return at.error("type", in_quotes(type) + " is not point, spot or directional");
  LUEUR_TRY(intensity, at.number("intensity", 1.0f));
  std::array<float, 3> color{1.0f, 1.0f, 1.0f};
  LUEUR_TRY_VOID(at.numbers("color", color));
  light.intensity = intensity;
  light.color = glm::make_vec3(color.data());
  for (const float value : {intensity, color[0], color[1], color[2]})
    if (!(value >= 0.0f && value <= kMaxIntensity))
      return at.error("intensity and color have to be 0 to 1e12");
  LUEUR_TRY(spot, at.object("spot"));
  LUEUR_TRY(inner, spot.number("innerConeAngle", 0.0f));
  LUEUR_TRY(outer, spot.number("outerConeAngle", 0.7854f));
  if (!(inner >= 0.0f && inner < outer && outer <= kRightAngle + 1e-4f))
    return spot.error("cone angles have to be 0 <= inner < outer <= pi/2");
  light.inner_cone_rad = inner;
  light.outer_cone_rad = std::min(outer, kRightAngle);
  if (!at.has("range")) return light;
  LUEUR_TRY(range, at.number("range", 0.0f));
  if (!(range > 0.0f)) return at.error("range", "has to be more than 0");
  if (light.kind == LightKind::directional)
    warnings.add("the range of a directional light is ignored: it has no distance");
  else
    light.range_m = range;
  return light;
}

}  // namespace

void set_transform(Node& node, const glm::mat4& matrix) {
  const glm::vec3 translation(matrix[3]);
  glm::mat3 axes(matrix);
  glm::vec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  if (glm::determinant(axes) < 0.0f) scale.x = -scale.x;
  for (int i = 0; i < 3; ++i) axes[i] /= scale[i];
  const glm::quat rotation = glm::normalize(glm::quat_cast(axes));

  // Keep the matrix where the three parts do not give it back: it has shear, or a zero scale.
  const glm::mat3 rebuilt =
      glm::mat3_cast(rotation) * glm::mat3(glm::scale(glm::mat4(1.0f), scale));
  const float size = std::max({std::abs(scale.x), scale.y, scale.z});
  bool same = true;
  for (int i = 0; i < 3; ++i)
    same = same && glm::length(rebuilt[i] - glm::vec3(matrix[i])) <= 1e-5f * size;  // NaN: false
  if (!same) {
    node.matrix = matrix;
    return;
  }
  node.translation = translation;
  node.rotation = rotation;
  node.scale = scale;
}

Result<NodeTree> read_nodes(const GltfFile& file) {
  const JsonCursor top = file.root();
  LUEUR_TRY(nodes, top.array("nodes"));
  if (nodes.size() > file.limits().nodes)
    return nodes.error(std::to_string(nodes.size()) + " nodes are more than the limit of " +
                       std::to_string(file.limits().nodes) + "; merge some");
  LUEUR_TRY(forest, read_forest(nodes));
  LUEUR_TRY_VOID(refuse_cycles(nodes, forest));
  LUEUR_TRY(roots, read_roots(file, forest));

  NodeTree tree;
  tree.file_nodes = parents_first(forest, roots);
  tree.node_of_file_node.assign(nodes.size(), kNone);
  Scene posed;
  for (size_t i = 0; i < tree.file_nodes.size(); ++i) {
    const size_t file_node = static_cast<size_t>(tree.file_nodes[i]);
    tree.node_of_file_node[file_node] = static_cast<int32_t>(i);
    LUEUR_TRY(at, nodes.element(file_node));
    Node node;
    LUEUR_TRY(name, at.text("name", ""));
    node.name = name;
    const int32_t parent = forest.parents[file_node];
    if (parent != kNone) node.parent = tree.node_of_file_node[static_cast<size_t>(parent)];
    LUEUR_TRY_VOID(read_transform(at, node));
    posed.nodes.push_back(std::move(node));
  }

  // Check the products too: finite transforms can multiply to infinity down a branch.
  const std::vector<glm::mat4> world_from_node = pose(posed, 0.0f);
  for (size_t i = 0; i < world_from_node.size(); ++i)
    if (!is_finite(world_from_node[i]))
      return nodes.error("node " + std::to_string(tree.file_nodes[i]) +
                         " has a transform that is not finite; re-export the file");
  tree.nodes = std::move(posed.nodes);
  return tree;
}

Result<std::vector<Camera>> read_cameras(const GltfFile& file, const NodeTree& tree,
                                         Warnings& warnings) {
  std::vector<Camera> cameras;
  const JsonCursor top = file.root();
  LUEUR_TRY(nodes, top.array("nodes"));
  LUEUR_TRY(definitions, top.array("cameras"));
  for (size_t i = 0; i < tree.nodes.size(); ++i) {
    LUEUR_TRY(node, nodes.element(static_cast<size_t>(tree.file_nodes[i])));
    LUEUR_TRY(index, node.index("camera", definitions.size(), "cameras"));
    if (index == kNone) continue;
    LUEUR_TRY(at, definitions.element(static_cast<size_t>(index)));
    LUEUR_TRY(type, at.text("type", ""));
    if (type == "orthographic") {
      warnings.add("orthographic cameras are not supported: left out");
      continue;
    }
    if (type != "perspective")
      return at.error("type", in_quotes(type) + " is not perspective or orthographic");
    LUEUR_TRY(camera, read_camera(at, static_cast<int32_t>(i)));
    if (camera.name.empty()) camera.name = tree.nodes[i].name;
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

Result<std::vector<Light>> read_lights(const GltfFile& file, const NodeTree& tree,
                                       Warnings& warnings) {
  constexpr const char* kExtension = "KHR_lights_punctual";
  std::vector<Light> lights;
  const JsonCursor top = file.root();
  LUEUR_TRY(nodes, top.array("nodes"));
  LUEUR_TRY(top_extensions, top.object("extensions"));
  LUEUR_TRY(punctual, top_extensions.object(kExtension));
  LUEUR_TRY(definitions, punctual.array("lights"));
  for (size_t i = 0; i < tree.nodes.size(); ++i) {
    LUEUR_TRY(node, nodes.element(static_cast<size_t>(tree.file_nodes[i])));
    LUEUR_TRY(extensions, node.object("extensions"));
    LUEUR_TRY(reference, extensions.object(kExtension));
    LUEUR_TRY(index, reference.index("light", definitions.size(), "lights"));
    if (index == kNone) continue;
    LUEUR_TRY(at, definitions.element(static_cast<size_t>(index)));
    LUEUR_TRY(light, read_light(at, static_cast<int32_t>(i), warnings));
    if (light.name.empty()) light.name = tree.nodes[i].name;
    lights.push_back(std::move(light));
  }
  return lights;
}

}  // namespace lueur
