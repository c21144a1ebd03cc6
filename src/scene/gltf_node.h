// SPDX-License-Identifier: MIT
// The node tree of a glTF file's default scene, with what hangs on it.
#pragma once

#include <cstdint>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_file.h"
#include "scene/scene.h"

namespace lueur {

struct NodeTree {
  std::vector<Node> nodes;                 // parents before children
  std::vector<int32_t> file_nodes;         // the file's node of each of `nodes`
  std::vector<int32_t> node_of_file_node;  // kNone: not in the scene
};

// Reads the default scene's nodes: `scene`, or the first, or every root where there are no scenes.
// Refuses cycles, nodes with two parents, and transforms that are not finite.
Result<NodeTree> read_nodes(const GltfFile& file);

// Cameras and lights that the tree's nodes carry.
Result<std::vector<Camera>> read_cameras(const GltfFile& file, const NodeTree& tree,
                                         Warnings& warnings);
Result<std::vector<Light>> read_lights(const GltfFile& file, const NodeTree& tree,
                                       Warnings& warnings);

// Splits a matrix without shear into translation, rotation and scale; keeps others as Node::matrix.
void set_transform(Node& node, const glm::mat4& matrix);

}  // namespace lueur
