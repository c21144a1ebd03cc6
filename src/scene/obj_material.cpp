// SPDX-License-Identifier: MIT
#include "scene/obj_material.h"

#include <algorithm>
#include <array>

#include "base/try.h"
#include "scene/gltf_json.h"

namespace lueur {
namespace {

constexpr float kUntoldAlbedo = 0.8f;

glm::vec3 shares(const glm::vec3& color, Warnings& warnings) {
  const glm::vec3 clamped = glm::clamp(color, 0.0f, 1.0f);
  if (clamped != color) warnings.add("materials: Kd and Ks outside 0 to 1 are clamped");
  return clamped;
}

void set_gloss(const MtlMaterial& from, Warnings& warnings, Material& material) {
  constexpr float kMostShininess = 1e5f;
  material.specular = 0.0f;
  const glm::vec3 color = shares(from.specular.value_or(glm::vec3(0.0f)), warnings);
  if (!from.has_gloss || color == glm::vec3(0.0f)) return;
  material.phong = PhongLobe{
      .color = color, .exponent = std::clamp(from.shininess.value_or(1.0f), 0.0f, kMostShininess)};
  const glm::vec3 both = color + glm::vec3(material.base_color);
  if (std::max({both.r, both.g, both.b}) > 1.0f)
    warnings.add("material " + in_quotes(from.name) +
                 " reflects more light than it gets: Kd and Ks together are above 1");
}

// The factor of a channel that may have a map.
float factor(const std::optional<float>& value, const std::optional<MtlMap>& map, float untold) {
  return std::clamp(value.value_or(map ? 1.0f : untold), 0.0f, 1.0f);
}

// A vertex has one set of texture coordinates: the first map tells how they lie.
UvTransform common_transform(const MtlMaterial& from, Warnings& warnings) {
  std::optional<UvTransform> common;
  for (const auto* map : {&from.diffuse_map, &from.normal_map, &from.bump_map, &from.emission_map,
                          &from.dissolve_map, &from.roughness_map, &from.metallic_map}) {
    if (!*map) continue;
    if (common && *common != (*map)->uv)
      warnings.add("material " + in_quotes(from.name) +
                   ": its maps have different -s or -o; the first one's hold for all");
    if (!common) common = (*map)->uv;
  }
  return common.value_or(UvTransform{});
}

const MtlMap* address(const std::optional<MtlMap>& map) {
  return map ? &*map : nullptr;
}

Result<void> set_textures(const MtlMaterial& from, ObjTextures& textures, Material& material) {
  if (from.dissolve_map) {
    LUEUR_TRY(color, textures.cut_out(address(from.diffuse_map), *from.dissolve_map));
    material.base_color_texture = color;
    material.alpha_mode = AlphaMode::mask;
  } else if (from.diffuse_map) {
    LUEUR_TRY(color, textures.picture(*from.diffuse_map));
    material.base_color_texture = color;
  }
  if (from.emission_map) {
    LUEUR_TRY(emission, textures.picture(*from.emission_map));
    material.emission_texture = emission;
  }
  if (from.normal_map) {
    LUEUR_TRY(normal, textures.picture(*from.normal_map));
    material.normal_texture = normal;
  } else if (from.bump_map) {
    LUEUR_TRY(normal, textures.bumps(*from.bump_map));
    material.normal_texture = normal;
  }
  if (from.roughness_map || from.metallic_map) {
    LUEUR_TRY(both,
              textures.metallic_roughness(address(from.roughness_map), address(from.metallic_map)));
    material.metallic_roughness_texture = both;
  }
  return {};
}

}  // namespace

ObjMaterial default_obj_material() {
  Material material;
  material.name = "default";
  material.base_color = {glm::vec3(kUntoldAlbedo), 1.0f};
  material.metallic = 0.0f;
  material.specular = 0.0f;
  material.double_sided = true;
  return {material, {}};
}

Result<ObjMaterial> make_obj_material(const MtlMaterial& from, ObjTextures& textures,
                                      Warnings& warnings) {
  constexpr float kMaxRadiance = 1e9f;  // the sun's disc
  Material material;
  material.name = from.name;
  material.double_sided = true;
  const glm::vec3 untold(from.diffuse_map ? 1.0f : kUntoldAlbedo);
  material.base_color = {shares(from.diffuse.value_or(untold), warnings), 1.0f};

  const bool is_pbr = from.roughness || from.metallic || from.roughness_map || from.metallic_map;
  material.metallic = is_pbr ? factor(from.metallic, from.metallic_map, 0.0f) : 0.0f;
  material.roughness = is_pbr ? factor(from.roughness, from.roughness_map, 1.0f) : 1.0f;
  if (!is_pbr) set_gloss(from, warnings, material);

  material.emission = from.emission.value_or(glm::vec3(from.emission_map ? 1.0f : 0.0f));
  for (int i = 0; i < 3; ++i)
    if (!(material.emission[i] >= 0.0f && material.emission[i] <= kMaxRadiance))
      return Error{ErrorKind::input, from.place + ": Ke of material " + in_quotes(from.name) +
                                         " has to be 0 to 1e9 cd/m2"};

  const float alpha = std::clamp(from.dissolve.value_or(1.0f), 0.0f, 1.0f);
  if (alpha < 1.0f) {
    material.base_color.a = alpha;
    material.alpha_mode = AlphaMode::mask;
    warnings.add("material " + in_quotes(from.name) + ": blending is not supported: it is " +
                 (alpha < material.alpha_cutoff ? "not drawn" : "drawn as opaque"));
  } else if (from.is_clear) {
    warnings.add("material " + in_quotes(from.name) +
                 ": refraction is not supported: it is drawn as opaque");
  }
  LUEUR_TRY_VOID(set_textures(from, textures, material));
  return ObjMaterial{std::move(material), common_transform(from, warnings)};
}

}  // namespace lueur
