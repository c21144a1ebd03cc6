// SPDX-License-Identifier: MIT
// Scene files of every format that is read.
#pragma once

#include <filesystem>
#include <string_view>

#include "lueur/result.h"
#include "scene/load_limits.h"
#include "scene/scene.h"

namespace lueur {

inline constexpr std::string_view kSceneFileEndings = ".gltf, .glb, .obj";

// Whether the name ends in one of them, in small letters or capitals.
bool has_scene_ending(const std::filesystem::path& path);

// Reads a scene: a GLB by its content, an OBJ by its ending or by how its text begins, glTF
// otherwise. Fails as load_gltf() and load_obj() do.
Result<Scene> load_scene_file(const std::filesystem::path& path, const LoadLimits& limits = {});

}  // namespace lueur
