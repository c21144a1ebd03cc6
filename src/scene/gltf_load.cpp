// SPDX-License-Identifier: MIT
#include "scene/gltf_load.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "base/try.h"
#include "scene/gltf_animation.h"
#include "scene/gltf_file.h"
#include "scene/gltf_material.h"
#include "scene/gltf_mesh.h"
#include "scene/gltf_node.h"
#include "scene/gltf_texture.h"

namespace lueur {
namespace {

// Extensions that are read, or whose own reader warns about them.
constexpr std::array kHandledExtensions{
    std::string_view("KHR_lights_punctual"), std::string_view("KHR_materials_emissive_strength"),
    std::string_view("KHR_materials_specular"), std::string_view("KHR_mesh_quantization"),
    std::string_view("KHR_texture_transform"), std::string_view("EXT_mesh_gpu_instancing")};

Result<void> warn_of_extensions(const GltfFile& file, Warnings& warnings) {
  const JsonCursor top = file.root();
  LUEUR_TRY(used, top.texts("extensionsUsed"));
  for (const std::string& extension : used) {
    if (std::find(kHandledExtensions.begin(), kHandledExtensions.end(), extension) ==
        kHandledExtensions.end())
      warnings.add(printable(extension) + " is not supported: drawn without it");
  }
  return {};
}

// Reads each mesh that a node of the scene uses, once.
Result<void> read_meshes(const GltfFile& file, const NodeTree& tree, GltfMaterials& materials,
                         Warnings& warnings, Scene& scene) {
  constexpr int32_t kUnread = -2;
  GeometryBudget budget{file.limits().vertices, file.limits().indices};
  const JsonCursor top = file.root();
  LUEUR_TRY(nodes, top.array("nodes"));
  std::vector<int32_t> place_of_mesh(file.size_of("meshes"), kUnread);
  for (size_t i = 0; i < tree.nodes.size(); ++i) {
    LUEUR_TRY(node, nodes.element(static_cast<size_t>(tree.file_nodes[i])));
    LUEUR_TRY(index, node.index("mesh", place_of_mesh.size(), "meshes"));
    if (index == kNone) continue;
    int32_t& place = place_of_mesh[static_cast<size_t>(index)];
    if (place == kUnread) {
      LUEUR_TRY(mesh, read_mesh(file, index, materials, budget, warnings));
      place = mesh.primitives.empty() ? kNone : static_cast<int32_t>(scene.meshes.size());
      if (place != kNone) scene.meshes.push_back(std::move(mesh));
    }
    if (place != kNone) scene.instances.push_back({static_cast<int32_t>(i), place});
  }
  if (scene.instances.empty()) warnings.add("the scene has no triangles: there is nothing to draw");
  return {};
}

Result<Scene> read_scene(const std::filesystem::path& path, const LoadLimits& limits) {
  LUEUR_TRY(file, GltfFile::open(path, limits));
  Warnings warnings;
  LUEUR_TRY_VOID(warn_of_extensions(file, warnings));
  GltfTextures textures(file, warnings);
  GltfMaterials materials(file, textures, warnings);

  Scene scene;
  scene.name = path.stem().string();
  LUEUR_TRY(tree, read_nodes(file, warnings));
  LUEUR_TRY_VOID(read_meshes(file, tree, materials, warnings, scene));
  LUEUR_TRY(cameras, read_cameras(file, tree, warnings));
  LUEUR_TRY(lights, read_lights(file, tree, warnings));
  LUEUR_TRY(animation, read_animation(file, tree, warnings));
  // Decode last: only what the meshes turned out to use.
  LUEUR_TRY(decoded, textures.decode());
  scene.nodes = std::move(tree.nodes);
  scene.cameras = std::move(cameras);
  scene.lights = std::move(lights);
  scene.animation = std::move(animation);
  scene.materials = materials.take();
  scene.textures = std::move(decoded);
  scene.warnings = warnings.take();
  return scene;
}

}  // namespace

Result<Scene> load_gltf(const std::filesystem::path& path, const LoadLimits& limits) {
  // Catch here what the parser and the containers may throw: no exception leaves this folder.
  try {
    return read_scene(path, limits);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, path.string() + ": not enough memory to load it"};
  }
}

}  // namespace lueur
