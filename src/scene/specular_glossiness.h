// SPDX-License-Identifier: MIT
// KHR_materials_pbrSpecularGlossiness as the metallic-roughness model that everything else here
// uses.
#pragma once

#include <cstdint>
#include <vector>

#include "lueur/result.h"
#include "scene/scene.h"

namespace lueur {

// The extension's numbers and textures.
struct SpecularGlossiness {
  glm::vec4 diffuse{1.0f};      // linear Rec.709 and alpha; multiplies its texture
  glm::vec3 specular{1.0f};     // F0, linear; multiplies its texture
  float glossiness = 1.0f;      // multiplies the same texture's alpha
  TextureUse diffuse_texture;   // sRGB
  TextureUse specular_texture;  // rgb: sRGB F0, a: glossiness
};

struct MetallicRoughness {
  glm::vec3 base_color{0.0f};
  float metallic = 0.0f;
  float specular = 1.0f;  // share of a dielectric's 0.04
};

// The surface that reflects the same: c = diffuse (1 - max(specular)) and F0 = specular are
// c = base (1 - m) and F0 = 0.04 s (1 - m) + base m, solved for m by their means over the channels.
// Exact for grey; colours that no metal-dielectric mix has get the nearest in their mean.
MetallicRoughness metallic_roughness_of(const glm::vec3& diffuse, const glm::vec3& specular);

// Sets the material's base colour, metallic, roughness, specular and their textures. New textures
// are appended to `textures`, which holds those that `from` names; `bytes_left` caps them.
// Returns false where they do not fit.
bool convert(const SpecularGlossiness& from, Material& material, std::vector<Texture>& textures,
             uint64_t& bytes_left);

}  // namespace lueur
