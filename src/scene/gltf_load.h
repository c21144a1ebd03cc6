// SPDX-License-Identifier: MIT
// Reads glTF 2.0 (.gltf with its files, or .glb) into a Scene. The file may come from anyone: every
// offset, count, size and path in it is checked before it is used.
//
// Read: the default scene's nodes, triangles (lists, strips, fans), vertex colours, two sets of
// texture coordinates a material, metallic-roughness materials, PNG and JPEG textures, perspective
// cameras, skins (four joints a vertex), morph targets, and the first animation.
// Extensions: KHR_lights_punctual, KHR_materials_emissive_strength, KHR_materials_specular (its
// factor alone), KHR_materials_unlit, KHR_materials_pbrSpecularGlossiness (converted),
// KHR_mesh_quantization, KHR_texture_transform, EXT_mesh_gpu_instancing, EXT_meshopt_compression.
// Missing normals are made flat, missing tangents from the texture coordinates. A mesh used by
// several nodes is stored once. Node transforms stay on the nodes, mirroring ones included.
//
// Everything else is either left out with a line in Scene::warnings (points and lines,
// orthographic cameras, optional extensions), or refused where leaving it out would show
// something else than the author made (extensions the file calls required).
#pragma once

#include <cstdint>
#include <filesystem>

#include "lueur/result.h"
#include "scene/scene.h"

namespace lueur {

// What one asset may ask for; checked before memory is taken for it.
struct LoadLimits {
  uint64_t file_bytes = uint64_t{1} << 30;  // all files of the asset together
  uint64_t vertices = uint64_t{64} << 20;   // all meshes together
  uint64_t indices = uint64_t{64} << 20;
  uint64_t nodes = uint64_t{1} << 20;
  uint64_t images = 4096;
  uint32_t texture_side_px = 16384;
  uint64_t texture_bytes = uint64_t{2} << 30;  // decoded, all textures together
  uint64_t json_values = uint64_t{16} << 20;
  uint32_t json_depth = 64;
};

// Fails with ErrorKind::input and a line that names the file, the JSON path and the remedy. Buffers
// and images are read only from the folder of `path` and below it. The scene has no default camera
// or light; see scene/framing.h.
Result<Scene> load_gltf(const std::filesystem::path& path, const LoadLimits& limits = {});

}  // namespace lueur
