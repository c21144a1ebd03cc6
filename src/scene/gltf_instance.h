// SPDX-License-Identifier: MIT
// The mesh instances of a glTF file: what its nodes draw, with their skins, morph weights and
// copies.
#pragma once

#include <cstdint>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_file.h"
#include "scene/gltf_node.h"
#include "scene/scene.h"

namespace lueur {

// In a node's `extras`: see read_passes_light_on().
inline constexpr const char* kPassesLightOnKey = "lueur_passes_light_on";

// Reads skin `index`, which must exist. Its joints have to be nodes of the scene.
Result<Skin> read_skin(const GltfFile& file, int32_t index, const NodeTree& tree);

// Refuses a mesh whose vertices follow joints that the skin does not have.
Result<void> check_fit(const JsonCursor& node, const Mesh& mesh, const Skin& skin);

// The weights of the node's mesh at rest: the node's own, or the mesh', or zeros.
Result<std::vector<float>> read_morph_weights(const GltfFile& file, const JsonCursor& node,
                                              int32_t file_mesh, const Mesh& mesh);

// MeshInstance::passes_light_on, by the node's `extras`. They may hold anything of anybody's; ours
// is true or false.
Result<bool> read_passes_light_on(const JsonCursor& node);

// The local transforms of the copies that EXT_mesh_gpu_instancing asks for; empty where the node
// does not have it. At most `most` of them.
Result<std::vector<Node>> read_copies(const GltfFile& file, const JsonCursor& node, uint64_t most);

}  // namespace lueur
