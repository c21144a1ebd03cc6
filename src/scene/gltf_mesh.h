// SPDX-License-Identifier: MIT
// The triangles of one glTF mesh.
#pragma once

#include <cstdint>

#include "lueur/result.h"
#include "scene/gltf_file.h"
#include "scene/gltf_material.h"
#include "scene/scene.h"

namespace lueur {

// What is left of LoadLimits for the meshes still to come.
struct GeometryBudget {
  uint64_t vertices = 0;
  uint64_t indices = 0;
};

// Reads mesh `index`, which must exist. The mesh comes back without primitives if it holds only
// points, lines or nothing. Takes what it uses from `budget`, before memory is taken.
Result<Mesh> read_mesh(const GltfFile& file, int32_t index, GltfMaterials& materials,
                       GeometryBudget& budget, Warnings& warnings);

}  // namespace lueur
