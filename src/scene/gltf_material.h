// SPDX-License-Identifier: MIT
// The materials that the primitives in use ask for.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_file.h"
#include "scene/gltf_texture.h"
#include "scene/scene.h"
#include "scene/specular_glossiness.h"

namespace lueur {

class GltfMaterials {
 public:
  struct Use {
    int32_t material = 0;  // in Scene::materials
    // The TEXCOORD_n that Vertex::uv and Vertex::uv_2 hold.
    std::array<std::optional<uint32_t>, 2> uv_sets;
  };

  GltfMaterials(const GltfFile& file, GltfTextures& textures, Warnings& warnings)
      : file_(&file), textures_(&textures), warnings_(&warnings) {}

  // Reads material `index` of the file when it is first asked for. kNone is glTF's default
  // material.
  Result<Use> use(int32_t index);

  // All that were used, at least one. Materials of the specular-glossiness model are converted;
  // `textures` holds what the textures decoded to, and gets theirs.
  Result<std::vector<Material>> take(std::vector<Texture>& textures);

 private:
  Result<Material> read(const JsonCursor& at);
  Result<void> read_specular_glossiness(const JsonCursor& at);
  Result<void> read_textures(const JsonCursor& at, const JsonCursor& pbr, Material& material);
  Result<void> read_alpha(const JsonCursor& at, Material& material);
  void choose_uv_sets(Material& material, Use& use);
  Result<float> unit_number(const JsonCursor& at, const char* key, float fallback);

  const GltfFile* file_;
  GltfTextures* textures_;
  Warnings* warnings_;
  std::vector<Material> materials_;
  std::map<int32_t, Use> uses_;
  std::map<size_t, SpecularGlossiness> to_convert_;  // by place in materials_
};

}  // namespace lueur
