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

#include <filesystem>
#include <string>
#include <vector>

#include "lueur/result.h"
#include "scene/load_limits.h"
#include "scene/scene.h"

namespace lueur {

// Fails with ErrorKind::input and a line that names the file, the JSON path and the remedy. Buffers
// and images are read only from the folder of `path` and below it. The scene has no default camera
// or light; see scene/framing.h.
Result<Scene> load_gltf(const std::filesystem::path& path, const LoadLimits& limits = {});

// The same for the bytes of a file, which `name` stands for in messages. No other file is read.
Result<Scene> decode_gltf(std::vector<uint8_t> bytes, const std::string& name,
                          const LoadLimits& limits = {});

}  // namespace lueur
