// SPDX-License-Identifier: MIT
#include <png.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/try.h"
#include "scene/gltf_export_parts.h"

namespace lueur {
namespace {

// glTF's numbers of sampler modes.
constexpr int kNearest = 9728, kLinear = 9729, kLinearMipmapLinear = 9987;
constexpr int kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497;

int wrap_mode(Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp_to_edge:
      return kClampToEdge;
    case Wrap::mirrored_repeat:
      return kMirroredRepeat;
    case Wrap::repeat:
      break;
  }
  return kRepeat;
}

// Encodes a texture, without alpha if it is opaque everywhere.
Result<std::vector<uint8_t>> encode_png(const Texture& texture) {
  LUEUR_CHECK_OP(texture.rgba.size(), ==, size_t{texture.width} * texture.height * 4);
  std::vector<uint8_t> pixels;
  bool opaque = true;
  for (size_t k = 3; k < texture.rgba.size(); k += 4) opaque = opaque && texture.rgba[k] == 255;
  if (opaque) {
    for (size_t k = 0; k < texture.rgba.size(); ++k)
      if (k % 4 != 3) pixels.push_back(texture.rgba[k]);
  } else {
    pixels = texture.rgba;
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = texture.width;
  image.height = texture.height;
  image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;

  // Give room for the worst case at once; asking for the size would encode twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<uint8_t> png(size);
  if (png_image_write_to_memory(&image, png.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    return Error{ErrorKind::output,
                 "texture '" + texture.name + "' cannot be encoded: " + image.message};
  png.resize(size);
  return png;
}

int add_sampler(GlbWriter& glb, const Texture& texture) {
  const OrderedJson sampler = {{"magFilter", texture.nearest ? kNearest : kLinear},
                               {"minFilter", kLinearMipmapLinear},
                               {"wrapS", wrap_mode(texture.wrap_u)},
                               {"wrapT", wrap_mode(texture.wrap_v)}};
  const OrderedJson& samplers = glb.json()["samplers"];
  const auto found = std::find(samplers.begin(), samplers.end(), sampler);
  return found != samplers.end() ? int(found - samplers.begin()) : glb.add_to("samplers", sampler);
}

// Scale, angle and offset of a transform without shear, which is all that files can bring.
OrderedJson transform_json(const glm::mat3x2& m) {
  const glm::vec2 scale(glm::length(m[0]),
                        glm::length(m[1]) * (glm::determinant(glm::mat2(m)) < 0.0f ? -1 : 1));
  return {{"offset", {m[2].x, m[2].y}},
          {"rotation", std::atan2(-m[0].y, m[0].x)},
          {"scale", {scale.x, scale.y}}};
}

bool set_texture(GlbWriter& glb, OrderedJson& object, const char* slot, const TextureUse& use) {
  if (!use.is_used()) return false;
  object[slot] = {{"index", use.texture}};
  if (use.uv_set != 0) object[slot]["texCoord"] = use.uv_set;
  if (use.transform != TextureUse().transform) {
    object[slot]["extensions"]["KHR_texture_transform"] = transform_json(use.transform);
    glb.use_extension("KHR_texture_transform");
  }
  return true;
}

// A factor of up to 1 for each channel, times a strength where that does not reach.
void set_emission(GlbWriter& glb, OrderedJson& material, glm::vec3 emission) {
  const float strength = std::max({emission.x, emission.y, emission.z, 1.0f});
  if (emission != glm::vec3(0.0f))
    material["emissiveFactor"] = vector_json(glm::min(emission / strength, glm::vec3(1.0f)));
  if (strength <= 1.0f) return;
  material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
  glb.use_extension("KHR_materials_emissive_strength");
}

void set_specular(GlbWriter& glb, OrderedJson& material, float specular) {
  if (specular == 1.0f) return;
  material["extensions"]["KHR_materials_specular"] = {{"specularFactor", specular}};
  glb.use_extension("KHR_materials_specular");
}

}  // namespace

Result<void> export_textures(GlbWriter& glb, const Scene& scene) {
  for (const Texture& texture : scene.textures) {
    LUEUR_TRY(png, encode_png(texture));
    const int image = glb.add_to(
        "images",
        {{"name", texture.name}, {"mimeType", "image/png"}, {"bufferView", glb.add_view(png)}});
    glb.add_to("textures",
               {{"name", texture.name}, {"sampler", add_sampler(glb, texture)}, {"source", image}});
  }
  return {};
}

void export_materials(GlbWriter& glb, const Scene& scene) {
  for (const Material& m : scene.materials) {
    OrderedJson pbr = {{"baseColorFactor", vector_json(m.base_color)},
                       {"metallicFactor", m.metallic},
                       {"roughnessFactor", m.roughness}};
    set_texture(glb, pbr, "baseColorTexture", m.base_color_texture);
    set_texture(glb, pbr, "metallicRoughnessTexture", m.metallic_roughness_texture);
    OrderedJson material = {{"name", m.name}, {"pbrMetallicRoughness", std::move(pbr)}};
    if (set_texture(glb, material, "normalTexture", m.normal_texture))
      material["normalTexture"]["scale"] = m.normal_scale;
    set_texture(glb, material, "emissiveTexture", m.emission_texture);
    set_emission(glb, material, m.emission);
    set_specular(glb, material, m.specular);
    if (m.unlit) {
      material["extensions"]["KHR_materials_unlit"] = OrderedJson::object();
      glb.use_extension("KHR_materials_unlit");
    }
    if (m.alpha_mode == AlphaMode::mask) {
      material["alphaMode"] = "MASK";
      material["alphaCutoff"] = m.alpha_cutoff;
    }
    if (m.double_sided) material["doubleSided"] = true;
    glb.add_to("materials", std::move(material));
  }
}

}  // namespace lueur
