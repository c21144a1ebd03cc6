// SPDX-License-Identifier: MIT
// Node animation of a glTF file.
#pragma once

#include <vector>

#include "lueur/result.h"
#include "scene/gltf_file.h"
#include "scene/gltf_node.h"
#include "scene/scene.h"

namespace lueur {

// Reads the first animation. Channels of morph weights become one for each target.
Result<std::vector<AnimationChannel>> read_animation(const GltfFile& file, const NodeTree& tree,
                                                     Warnings& warnings);

}  // namespace lueur
