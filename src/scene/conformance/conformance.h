// SPDX-License-Identifier: MIT
// Holds a glTF file against the specification: the schema of its objects, how they fit together,
// and what its buffers hold. The loader itself refuses what it cannot draw safely; this tells of
// faults that it can live with, so that nobody wonders about the picture.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf_file.h"

namespace lueur {

// One line for each fault, "meshes[3].primitives[0].mode: 9 is not one of 0 to 6", 16 at most and
// one that counts the rest. Each byte of the buffers is read a few times at most.
std::vector<std::string> conformance_faults(const GltfFile& file);

}  // namespace lueur
