// SPDX-License-Identifier: MIT
#include "scene/gltf_export.h"

#include <cstdint>
#include <new>
#include <span>
#include <vector>

#include "base/file.h"
#include "base/try.h"
#include "scene/gltf_export_parts.h"

namespace lueur {
namespace {

Result<std::vector<uint8_t>> glb_of(const Scene& scene) {
  GlbWriter glb;
  LUEUR_TRY_VOID(export_textures(glb, scene));
  export_materials(glb, scene);
  const std::vector<int> mesh_index = export_meshes(glb, scene);
  export_skins(glb, scene);
  export_nodes(glb, scene, mesh_index);
  export_animation(glb, scene);
  return glb.assemble(scene.name);
}

}  // namespace

Result<void> export_glb(const Scene& scene, const std::filesystem::path& path) {
  try {
    LUEUR_TRY(file, glb_of(scene));
    return write_file(path, std::span<const uint8_t>(file));
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, path.string() + ": not enough memory to export the scene"};
  }
}

}  // namespace lueur
