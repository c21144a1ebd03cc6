// SPDX-License-Identifier: MIT
#include "scene/gltf_material.h"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <utility>

#include "base/try.h"

namespace lueur {

Result<GltfMaterials::Use> GltfMaterials::use(int32_t index) {
  if (const auto known = uses_.find(index); known != uses_.end()) return known->second;
  Use use;
  Material material;
  material.name = "default";
  if (index != kNone) {
    const JsonCursor top = file_->root();
    LUEUR_TRY(materials, top.array("materials"));
    LUEUR_TRY(at, materials.element(static_cast<size_t>(index)));
    LUEUR_TRY(read_material, read(at));
    material = std::move(read_material);
    choose_uv_sets(material, use);
    if (material.name.empty()) material.name = "material " + std::to_string(index);
  }
  if (!use.uv_sets[0]) use.uv_sets[0] = 0;
  use.material = static_cast<int32_t>(materials_.size());
  materials_.push_back(std::move(material));
  uses_[index] = use;
  return use;
}

Result<std::vector<Material>> GltfMaterials::take(std::vector<Texture>& textures) {
  uint64_t bytes_left = file_->limits().texture_bytes;
  for (const Texture& texture : textures)
    bytes_left -= std::min<uint64_t>(texture.rgba.size(), bytes_left);
  for (const auto& [place, from] : to_convert_)
    if (!convert(from, materials_[place], textures, bytes_left))
      return Error{ErrorKind::input,
                   file_->name() + ": material '" + printable(materials_[place].name) +
                       "': converted to metallic-roughness, all textures together take more than " +
                       std::to_string(file_->limits().texture_bytes) + " bytes; resize them"};
  if (materials_.empty()) materials_.push_back({.name = "default"});
  return std::move(materials_);
}

Result<float> GltfMaterials::unit_number(const JsonCursor& at, const char* key, float fallback) {
  LUEUR_TRY(value, at.number(key, fallback));
  if (value < 0.0f || value > 1.0f) warnings_->add("material factors outside 0 to 1 are clamped");
  return std::clamp(value, 0.0f, 1.0f);
}

Result<Material> GltfMaterials::read(const JsonCursor& at) {
  Material material;
  LUEUR_TRY(name, at.text("name", ""));
  material.name = name;
  LUEUR_TRY(pbr, at.object("pbrMetallicRoughness"));
  std::array<float, 4> color{1.0f, 1.0f, 1.0f, 1.0f};
  LUEUR_TRY_VOID(pbr.numbers("baseColorFactor", color));
  for (int i = 0; i < 4; ++i) {
    const float value = color[static_cast<size_t>(i)];
    material.base_color[i] = std::clamp(value, 0.0f, 1.0f);
    if (value != material.base_color[i])
      warnings_->add("material factors outside 0 to 1 are clamped");
  }
  LUEUR_TRY(metallic, unit_number(pbr, "metallicFactor", 1.0f));
  LUEUR_TRY(roughness, unit_number(pbr, "roughnessFactor", 1.0f));
  material.metallic = metallic;
  material.roughness = roughness;

  LUEUR_TRY(extensions, at.object("extensions"));
  LUEUR_TRY(specular_at, extensions.object("KHR_materials_specular"));
  LUEUR_TRY(specular, unit_number(specular_at, "specularFactor", 1.0f));
  material.specular = specular;
  for (const char* left_out : {"specularTexture", "specularColorFactor", "specularColorTexture"})
    if (specular_at.has(left_out))
      warnings_->add("KHR_materials_specular: only its specularFactor is used");

  // Emission is a factor times a strength; older files put all of it into the factor.
  std::array<float, 3> emission{};
  LUEUR_TRY_VOID(at.numbers("emissiveFactor", emission));
  LUEUR_TRY(strength_at, extensions.object("KHR_materials_emissive_strength"));
  LUEUR_TRY(strength, strength_at.number("emissiveStrength", 1.0f));
  constexpr float kMaxRadiance = 1e9f;  // the sun's disc
  for (int i = 0; i < 3; ++i) {
    const float radiance = emission[static_cast<size_t>(i)] * strength;
    if (!(radiance >= 0.0f && radiance <= kMaxRadiance))
      return at.error("emissiveFactor", "times emissiveStrength has to be 0 to 1e9 cd/m2");
    material.emission[i] = radiance;
  }
  LUEUR_TRY(double_sided, at.boolean("doubleSided", false));
  material.double_sided = double_sided;
  material.unlit = extensions.has("KHR_materials_unlit");
  if (extensions.has("KHR_materials_pbrSpecularGlossiness")) {
    LUEUR_TRY(model, extensions.object("KHR_materials_pbrSpecularGlossiness"));
    LUEUR_TRY_VOID(read_specular_glossiness(model));
  }
  LUEUR_TRY_VOID(read_textures(at, pbr, material));
  LUEUR_TRY_VOID(read_alpha(at, material));
  return material;
}

// Takes the place of the metallic-roughness numbers, which such a material may have as a fallback.
Result<void> GltfMaterials::read_specular_glossiness(const JsonCursor& at) {
  SpecularGlossiness from;
  std::array<float, 4> diffuse{1.0f, 1.0f, 1.0f, 1.0f};
  std::array<float, 3> specular{1.0f, 1.0f, 1.0f};
  LUEUR_TRY_VOID(at.numbers("diffuseFactor", diffuse));
  LUEUR_TRY_VOID(at.numbers("specularFactor", specular));
  LUEUR_TRY(glossiness, unit_number(at, "glossinessFactor", 1.0f));
  LUEUR_TRY(diffuse_texture, textures_->use(at, "diffuseTexture"));
  LUEUR_TRY(specular_texture, textures_->use(at, "specularGlossinessTexture"));
  from.diffuse = glm::clamp(glm::make_vec4(diffuse.data()), 0.0f, 1.0f);
  from.specular = glm::clamp(glm::make_vec3(specular.data()), 0.0f, 1.0f);
  from.glossiness = glossiness;
  from.diffuse_texture = diffuse_texture;
  from.specular_texture = specular_texture;
  if (diffuse_texture.is_used() && specular_texture.is_used() &&
      (diffuse_texture.uv_set != specular_texture.uv_set ||
       diffuse_texture.transform != specular_texture.transform))
    warnings_->add(
        "KHR_materials_pbrSpecularGlossiness: the specular texture is drawn where the "
        "diffuse one lies");
  to_convert_[materials_.size()] = from;
  return {};
}

Result<void> GltfMaterials::read_textures(const JsonCursor& at, const JsonCursor& pbr,
                                          Material& material) {
  LUEUR_TRY(base_color, textures_->use(pbr, "baseColorTexture"));
  LUEUR_TRY(metallic_roughness, textures_->use(pbr, "metallicRoughnessTexture"));
  LUEUR_TRY(normal, textures_->use(at, "normalTexture"));
  LUEUR_TRY(emission, textures_->use(at, "emissiveTexture"));
  LUEUR_TRY(normal_info, at.object("normalTexture"));
  LUEUR_TRY(normal_scale, normal_info.number("scale", 1.0f));
  material.base_color_texture = base_color;
  material.metallic_roughness_texture = metallic_roughness;
  material.normal_texture = normal;
  material.emission_texture = emission;
  material.normal_scale = normal_scale;
  return {};
}

Result<void> GltfMaterials::read_alpha(const JsonCursor& at, Material& material) {
  LUEUR_TRY(mode, at.text("alphaMode", "OPAQUE"));
  if (mode == "MASK") {
    LUEUR_TRY(cutoff, at.number("alphaCutoff", 0.5f));
    material.alpha_mode = AlphaMode::mask;
    material.alpha_cutoff = cutoff;
  } else if (mode == "BLEND") {
    material.alpha_mode = AlphaMode::mask;
    warnings_->add("alpha blending is not supported: blended materials are cut out at alpha 0.5");
  } else if (mode != "OPAQUE") {
    return at.error("alphaMode", in_quotes(mode) + " is not OPAQUE, MASK or BLEND");
  }
  return {};
}

// A vertex has two sets of texture coordinates. The normal map, which tangents follow, is asked
// first for the one it wants.
void GltfMaterials::choose_uv_sets(Material& material, Use& use) {
  std::vector<TextureUse*> textures{&material.normal_texture, &material.base_color_texture,
                                    &material.metallic_roughness_texture,
                                    &material.emission_texture};
  if (const auto other = to_convert_.find(materials_.size()); other != to_convert_.end())
    textures.insert(textures.end(),
                    {&other->second.diffuse_texture, &other->second.specular_texture});
  for (TextureUse* texture : textures) {
    if (!texture->is_used()) continue;
    uint32_t slot = 0;
    while (slot < use.uv_sets.size() && use.uv_sets[slot] && *use.uv_sets[slot] != texture->uv_set)
      ++slot;
    if (slot == use.uv_sets.size()) {
      warnings_->add(
          "a material uses more than two sets of texture coordinates: the textures of "
          "the others are drawn with the first");
      slot = 0;
    }
    use.uv_sets[slot] = use.uv_sets[slot].value_or(texture->uv_set);
    texture->uv_set = slot;
  }
}

}  // namespace lueur
