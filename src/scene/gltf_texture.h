// SPDX-License-Identifier: MIT
// The textures that the materials in use ask for, each decoded once.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_file.h"
#include "scene/scene.h"

namespace lueur {

class GltfTextures {
 public:
  GltfTextures(GltfFile& file, Warnings& warnings) : file_(&file), warnings_(&warnings) {}

  // Notes the texture that `material`'s member `key`, a texture info, refers to, with its transform
  // (KHR_texture_transform). TextureUse::uv_set is the file's TEXCOORD_n.
  Result<TextureUse> use(const JsonCursor& material, const char* key);

  // Reads and decodes all that were noted, on all processor cores.
  Result<std::vector<Texture>> decode();

 private:
  struct Slot {
    int32_t image = 0;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    bool nearest = false;
    auto operator<=>(const Slot&) const = default;
  };
  Result<int32_t> place_of(const JsonCursor& texture);
  Result<void> read_sampler(const JsonCursor& texture, Slot& slot) const;

  GltfFile* file_;
  Warnings* warnings_;
  std::vector<Slot> slots_;
  std::map<Slot, int32_t> place_of_slot_;
};

}  // namespace lueur
