// SPDX-License-Identifier: MIT
#include "scene/gltf_texture.h"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/texture_decode.h"

namespace lueur {
namespace {

Result<Wrap> read_wrap(const JsonCursor& sampler, const char* key) {
  constexpr uint64_t kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;
  LUEUR_TRY(value, sampler.count(key, kRepeat, UINT32_MAX));
  if (value == kRepeat) return Wrap::repeat;
  if (value == kClampToEdge) return Wrap::clamp_to_edge;
  if (value == kMirroredRepeat) return Wrap::mirrored_repeat;
  return sampler.error(key, std::to_string(value) + " is not a wrap mode of glTF");
}

Result<EncodedImage> read_image(GltfFile& file, size_t index) {
  const JsonCursor top = file.root();
  LUEUR_TRY(images, top.array("images"));
  LUEUR_TRY(at, images.element(index));
  EncodedImage image;
  image.path = at.error("").message;
  LUEUR_TRY(uri, at.text("uri", ""));
  LUEUR_TRY(name, at.text("name", uri.starts_with("data:") ? "" : uri));
  image.name = name.empty() ? "image " + std::to_string(index) : name;
  LUEUR_TRY(view_index, at.index("bufferView", file.size_of("bufferViews"), "buffer views"));
  if (view_index != kNone) {
    LUEUR_TRY(view, file.view(view_index));
    image.bytes = view.bytes;
  } else if (!uri.empty()) {
    LUEUR_TRY(storage, file.read_uri(uri, at));
    image.storage = std::move(storage);
    image.bytes = image.storage;
  } else {
    return at.error("has neither a uri nor a bufferView; re-export the file");
  }

  if (const auto checked = read_header(image, file.limits()); !checked.ok())
    return at.error(checked.error().message);
  return image;
}

// Reads where on the texture a surface's coordinates lead: scaled, turned, then moved. On the
// picture, whose v points down, a positive angle turns the coordinates counter-clockwise.
Result<void> read_place(const JsonCursor& info, TextureUse& use) {
  constexpr uint64_t kMaxUvSet = 64;
  LUEUR_TRY(set, info.count("texCoord", 0, kMaxUvSet));
  LUEUR_TRY(extensions, info.object("extensions"));
  LUEUR_TRY(at, extensions.object("KHR_texture_transform"));
  LUEUR_TRY(set_instead, at.count("texCoord", set, kMaxUvSet));
  use.uv_set = static_cast<uint32_t>(set_instead);
  std::array<float, 2> offset{}, scale{1.0f, 1.0f};
  LUEUR_TRY_VOID(at.numbers("offset", offset));
  LUEUR_TRY_VOID(at.numbers("scale", scale));
  LUEUR_TRY(angle, at.number("rotation", 0.0f));
  const float c = std::cos(angle), s = std::sin(angle);
  use.transform =
      glm::mat3x2(scale[0] * c, -scale[0] * s, scale[1] * s, scale[1] * c, offset[0], offset[1]);
  return {};
}

}  // namespace

Result<TextureUse> GltfTextures::use(const JsonCursor& material, const char* key) {
  TextureUse use;
  if (!material.has(key)) return use;
  LUEUR_TRY(info, material.object(key));
  LUEUR_TRY(index, info.required_index("index", file_->size_of("textures"), "textures"));
  LUEUR_TRY_VOID(read_place(info, use));
  const JsonCursor top = file_->root();
  LUEUR_TRY(textures, top.array("textures"));
  LUEUR_TRY(texture, textures.element(static_cast<size_t>(index)));
  LUEUR_TRY(place, place_of(texture));
  if (place == kNone) return TextureUse();
  use.texture = place;
  return use;
}

Result<int32_t> GltfTextures::place_of(const JsonCursor& texture) {
  LUEUR_TRY(image, texture.index("source", file_->size_of("images"), "images"));
  if (image == kNone) {
    if (texture.has("extensions"))
      return texture.error(
          "only has an image in a format that is not supported; re-export with "
          "PNG or JPEG textures");
    warnings_->add("a texture without an image is drawn as white");
    return kNone;
  }

  Slot slot;
  slot.image = image;
  LUEUR_TRY_VOID(read_sampler(texture, slot));
  const auto known = place_of_slot_.find(slot);
  if (known != place_of_slot_.end()) return known->second;
  if (slots_.size() >= file_->limits().images)
    return texture.error("more than " + std::to_string(file_->limits().images) +
                         " textures are in use; merge some into atlases");
  const int32_t place = static_cast<int32_t>(slots_.size());
  slots_.push_back(slot);
  place_of_slot_[slot] = place;
  return place;
}

Result<void> GltfTextures::read_sampler(const JsonCursor& texture, Slot& slot) const {
  constexpr uint64_t kNearest = 9728, kLinear = 9729;
  LUEUR_TRY(index, texture.index("sampler", file_->size_of("samplers"), "samplers"));
  if (index == kNone) return {};
  const JsonCursor top = file_->root();
  LUEUR_TRY(samplers, top.array("samplers"));
  LUEUR_TRY(sampler, samplers.element(static_cast<size_t>(index)));
  LUEUR_TRY(wrap_u, read_wrap(sampler, "wrapS"));
  LUEUR_TRY(wrap_v, read_wrap(sampler, "wrapT"));
  LUEUR_TRY(magnify, sampler.count("magFilter", kLinear, UINT32_MAX));
  if (magnify != kNearest && magnify != kLinear)
    return sampler.error("magFilter", std::to_string(magnify) + " is not a filter of glTF");
  slot.wrap_u = wrap_u;
  slot.wrap_v = wrap_v;
  slot.nearest = magnify == kNearest;
  return {};
}

Result<std::vector<Texture>> GltfTextures::decode() {
  // Read every image once, however many samplers it is used with.
  std::vector<EncodedImage> images;
  std::map<int32_t, size_t> place_of_image;
  uint64_t total_bytes = 0;
  for (const Slot& slot : slots_) {
    if (!place_of_image.contains(slot.image)) {
      LUEUR_TRY(image, read_image(*file_, static_cast<size_t>(slot.image)));
      place_of_image[slot.image] = images.size();
      images.push_back(std::move(image));
    }
    const EncodedImage& image = images[place_of_image[slot.image]];
    total_bytes += uint64_t{image.header.width} * image.header.height * 4;
    if (total_bytes > file_->limits().texture_bytes)
      return Error{ErrorKind::input, image.path + "all textures together take more than " +
                                         std::to_string(file_->limits().texture_bytes) +
                                         " bytes; resize them"};
  }

  LUEUR_TRY_VOID(decode_all(images));

  // Copy the pixels where another slot still needs them, and move them otherwise.
  std::vector<size_t> uses(images.size(), 0);
  for (const Slot& slot : slots_) ++uses[place_of_image[slot.image]];
  std::vector<Texture> textures;
  for (const Slot& slot : slots_) {
    const size_t place = place_of_image[slot.image];
    EncodedImage& image = images[place];
    std::vector<uint8_t> rgba = --uses[place] == 0 ? std::move(image.rgba) : image.rgba;
    textures.push_back({image.name, image.header.width, image.header.height, std::move(rgba),
                        slot.wrap_u, slot.wrap_v, slot.nearest});
  }
  return textures;
}

}  // namespace lueur
