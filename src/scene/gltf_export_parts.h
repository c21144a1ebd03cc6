// SPDX-License-Identifier: MIT
// The parts of export_glb(), each for its arrays of the file. Indices into `textures`, `materials`,
// `skins`, `cameras`, `lights` and the first of `nodes` are the scene's own.
#pragma once

#include <vector>

#include "lueur/result.h"
#include "scene/glb_writer.h"
#include "scene/scene.h"

namespace lueur {

using OrderedJson = GlbWriter::Json;

// Fails (ErrorKind::output) when a texture cannot be encoded.
Result<void> export_textures(GlbWriter& glb, const Scene& scene);
void export_materials(GlbWriter& glb, const Scene& scene);

// Returns the index in the file of each of the scene's meshes, kNone where it has no triangles.
std::vector<int> export_meshes(GlbWriter& glb, const Scene& scene);
void export_skins(GlbWriter& glb, const Scene& scene);

// Cameras, lights, nodes and what is on them, and the scene that holds them.
void export_nodes(GlbWriter& glb, const Scene& scene, const std::vector<int>& mesh_index);
void export_animation(GlbWriter& glb, const Scene& scene);

}  // namespace lueur
