// SPDX-License-Identifier: MIT
// Writes a Scene as one binary glTF 2.0 file, so that any other renderer can show the same scene.
#pragma once

#include <filesystem>

#include "lueur/result.h"
#include "scene/scene.h"

namespace lueur {

// Writes meshes, materials, textures (PNG inside the file), cameras, lights (KHR_lights_punctual),
// emission (KHR_materials_emissive_strength beyond 1), nodes and the animation. glTF has no place
// for `exposure_ev`, `warnings`, the environment and Phong lobes; they are left out. Meshes without
// triangles are, too, and so are tangents of what has no normal map and what morph targets add to
// tangents.
//
// A node carries at most one mesh, camera and light in glTF; further ones get child nodes of their
// own at the end, so that indices of the scene's own nodes stay. The file appears whole or not at
// all. Fails (ErrorKind::output) when it cannot be written or would pass glTF's 4 GiB.
Result<void> export_glb(const Scene& scene, const std::filesystem::path& path);

}  // namespace lueur
