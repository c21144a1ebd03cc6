// SPDX-License-Identifier: MIT
#include "scene/obj_load.h"

#include <algorithm>
#include <map>
#include <new>
#include <string_view>

#include "base/file.h"
#include "base/try.h"
#include "scene/gltf_json.h"
#include "scene/gltf_uri.h"
#include "scene/obj_geometry.h"
#include "scene/obj_material.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

std::string_view text_of(const std::vector<uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// An asset being read: its folder, and what of its limits is spent.
class ObjReader {
 public:
  ObjReader(const fs::path& path, const LoadLimits& limits) : path_(path), limits_(&limits) {}
  Result<Scene> read();

 private:
  using Library = std::map<std::string, MtlMaterial, std::less<>>;
  Result<std::vector<uint8_t>> read_bytes(const fs::path& path);
  Result<Library> read_libraries(const std::vector<std::string>& names);
  Result<void> read_library(const std::string& name, Library& library);
  std::vector<std::string> files_of(const std::string& name) const;
  Result<std::vector<ObjMaterialUse>> read_materials(const ObjGeometry& geometry, Scene& scene);

  fs::path path_;
  const LoadLimits* limits_;
  uint64_t bytes_read_ = 0;
  Warnings warnings_;
};

Result<std::vector<uint8_t>> ObjReader::read_bytes(const fs::path& path) {
  LUEUR_TRY(bytes, read_file(path, limits_->file_bytes - bytes_read_));
  bytes_read_ += bytes.size();
  return std::move(bytes);
}

// One statement may name several files, and names may have spaces in them: what exists decides.
std::vector<std::string> ObjReader::files_of(const std::string& name) const {
  const auto whole = confined_file(path_.parent_path(), name);
  std::error_code failure;
  if (!whole.ok() || fs::exists(*whole, failure) || name.find(' ') == std::string::npos)
    return {name};
  std::vector<std::string> names;
  for (size_t begin = 0; begin < name.size();) {
    const size_t end = std::min(name.find(' ', begin), name.size());
    if (end > begin) names.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

Result<void> ObjReader::read_library(const std::string& name, Library& library) {
  const auto path = confined_file(path_.parent_path(), name);
  std::error_code failure;
  if (!path.ok() || !fs::exists(*path, failure)) {
    warnings_.add((path.ok() ? "the MTL file " + in_quotes(name) + " is missing"
                             : "mtllib: " + path.error().message) +
                  ": its materials are drawn as the default one");
    return {};
  }
  LUEUR_TRY(bytes, read_bytes(*path));
  LUEUR_TRY(materials, read_mtl(text_of(bytes), path->string(), warnings_));
  for (MtlMaterial& material : materials) library.try_emplace(material.name, std::move(material));
  return {};
}

Result<ObjReader::Library> ObjReader::read_libraries(const std::vector<std::string>& names) {
  Library library;
  for (const std::string& name : names)
    for (const std::string& file : files_of(name)) LUEUR_TRY_VOID(read_library(file, library));
  return library;
}

// Fills the scene's materials and textures with those in use.
Result<std::vector<ObjMaterialUse>> ObjReader::read_materials(const ObjGeometry& geometry,
                                                              Scene& scene) {
  LUEUR_TRY(library, read_libraries(geometry.libraries));
  ObjTextures textures(path_.parent_path(), *limits_, bytes_read_, warnings_);
  std::vector<bool> is_used(geometry.material_names.size());
  for (const ObjFace& face : geometry.faces) is_used[face.material] = true;

  std::vector<ObjMaterialUse> uses(geometry.material_names.size());
  int32_t default_place = kNone;
  for (size_t i = 0; i < uses.size(); ++i) {
    if (!is_used[i]) continue;
    const std::string& name = geometry.material_names[i];
    const auto found = library.find(name);
    if (found == library.end()) {
      if (!name.empty() && !library.empty())
        warnings_.add("the material " + in_quotes(name) +
                      " is in none of the MTL files: drawn as the default one");
      if (default_place == kNone) {
        default_place = static_cast<int32_t>(scene.materials.size());
        scene.materials.push_back(default_obj_material().material);
      }
      uses[i].material = default_place;
      continue;
    }
    LUEUR_TRY(made, make_obj_material(found->second, textures, warnings_));
    uses[i] = {static_cast<int32_t>(scene.materials.size()), made.uv};
    scene.materials.push_back(std::move(made.material));
  }
  if (scene.materials.empty()) scene.materials.push_back(default_obj_material().material);
  LUEUR_TRY(made_textures, textures.make());
  scene.textures = std::move(made_textures);
  return uses;
}

Result<Scene> ObjReader::read() {
  LUEUR_TRY(bytes, read_bytes(path_));
  const std::string file = path_.string();
  LUEUR_TRY(geometry, read_obj_geometry(text_of(bytes), file, *limits_, warnings_));
  bytes = {};
  Scene scene;
  scene.name = path_.stem().string();
  LUEUR_TRY(uses, read_materials(geometry, scene));
  LUEUR_TRY(meshes, make_obj_meshes(std::move(geometry), uses, file, *limits_, warnings_));
  scene.meshes = std::move(meshes);
  for (size_t i = 0; i < scene.meshes.size(); ++i) {
    Mesh& mesh = scene.meshes[i];
    if (mesh.name.empty()) mesh.name = scene.name;
    scene.nodes.push_back({.name = mesh.name});
    scene.instances.push_back({static_cast<int32_t>(i), static_cast<int32_t>(i)});
  }
  if (scene.instances.empty()) warnings_.add("the file has no polygons: there is nothing to draw");
  scene.warnings = warnings_.take();
  return scene;
}

}  // namespace

Result<Scene> load_obj(const fs::path& path, const LoadLimits& limits) {
  // Catch here what the containers may throw: no exception leaves this folder.
  try {
    return ObjReader(path, limits).read();
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, path.string() + ": not enough memory to load it"};
  }
}

}  // namespace lueur
