// SPDX-License-Identifier: MIT
// Images by their first bytes, and textures by the types of their images.
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "scene/conformance/rules.h"
#include "scene/gltf_uri.h"
#include "scene/image_decode.h"

namespace lueur::conformance {
namespace {

constexpr size_t kHeadBytes = 64 * 1024;  // JPEG keeps its size behind profiles and previews

struct Signature {
  std::string_view type;
  std::string_view start;
  size_t offset;
};
constexpr std::array kSignatures{
    Signature{"image/png", std::string_view("\x89PNG\r\n\x1a\n", 8), 0},
    Signature{"image/jpeg", "\xff\xd8\xff", 0}, Signature{"image/webp", "WEBP", 8},
    Signature{"image/ktx2", "\xabKTX 20\xbb", 0}};

// By what it starts with; empty if that is none of the above.
std::string_view type_of(std::span<const uint8_t> bytes) {
  for (const Signature& signature : kSignatures) {
    const size_t end = signature.offset + signature.start.size();
    if (bytes.size() >= end && std::memcmp(bytes.data() + signature.offset, signature.start.data(),
                                           signature.start.size()) == 0)
      return signature.type;
  }
  return {};
}

class ImageCheck {
 public:
  ImageCheck(Asset& asset, size_t index)
      : asset_(&asset), image_(&asset.list_of("images")[index]), path_(path_to("images", index)) {}

  // Returns the media type, as declared or as found.
  std::string check();

 private:
  std::vector<uint8_t> head();
  std::string declared_type() const;
  void check_head(std::span<const uint8_t> bytes);

  Asset* asset_;
  const Json* image_;
  std::string path_;
};

std::string ImageCheck::declared_type() const {
  const std::string_view given = text(*image_, "mimeType");
  if (!given.empty()) return std::string(given);
  return std::string(media_type(text(*image_, "uri")).value_or(std::string_view()));
}

std::vector<uint8_t> ImageCheck::head() {
  const Json& views = asset_->list_of("bufferViews");
  if (const auto view = index_below(*image_, "bufferView", views.size())) {
    const std::string at = path_to(path_, "bufferView");
    asset_->use_view(*view, ViewUse::image, at);
    if (has(views[*view], "byteStride")) asset_->add(at, "names a view that has a byteStride");
    const auto found = asset_->file.view(static_cast<int32_t>(*view));
    if (!found.ok()) return {};
    const auto bytes = found->bytes.first(std::min(found->bytes.size(), kHeadBytes));
    return {bytes.begin(), bytes.end()};
  }
  const std::string uri(text(*image_, "uri"));
  if (uri.empty()) return {};
  if (is_data_uri(uri) && !media_type(uri))
    asset_->add(path_to(path_, "uri"), "is not a valid data URI");
  auto bytes = asset_->file.head_of_uri(uri, kHeadBytes);
  if (!bytes.ok()) asset_->add(path_to(path_, "uri"), bytes.error().message);
  return bytes.ok() ? *bytes : std::vector<uint8_t>();
}

void ImageCheck::check_head(std::span<const uint8_t> bytes) {
  const std::string_view found = type_of(bytes);
  if (found != "image/png" && found != "image/jpeg") return;
  const auto header = read_image_header(bytes);
  if (bytes.size() >= kHeadBytes) return;  // the size may stand further on
  if (!header.ok()) return asset_->add(path_, header.error().message);
  if (header->width == 0 || header->height == 0) asset_->add(path_, "has no pixels");
}

std::string ImageCheck::check() {
  const std::vector<uint8_t> bytes = head();
  std::string declared = declared_type();
  if (bytes.empty()) return declared;
  const std::string found(type_of(bytes));
  check_head(bytes);
  if (!declared.empty() && !found.empty() && declared != found)
    asset_->add(has(*image_, "uri") ? path_to(path_, "uri") : path_,
                "is " + found + ", but declared as " + printable(declared));
  return found.empty() ? declared : found;
}

struct TextureRow {
  std::string_view extension;  // empty: the texture itself
  std::array<std::string_view, 2> types;
};
constexpr std::array kTextureRows{TextureRow{"", {"image/png", "image/jpeg"}},
                                  TextureRow{"EXT_texture_webp", {"image/webp"}},
                                  TextureRow{"KHR_texture_basisu", {"image/ktx2"}}};

void check_texture(Asset& asset, const Json& texture, const std::vector<std::string>& types,
                   const std::string& path) {
  for (const TextureRow& row : kTextureRows) {
    const Json& holder =
        row.extension.empty() ? texture : member(texture, {"extensions", row.extension});
    const auto image = index_below(holder, "source", types.size());
    if (!image || types[*image].empty()) continue;
    if (std::ranges::find(row.types, types[*image]) != row.types.end()) continue;
    const std::string at =
        row.extension.empty() ? path : path + ".extensions." + std::string(row.extension);
    asset.add(path_to(at, "source"), path_to("images", *image) + " is " + printable(types[*image]) +
                                         ", which does not fit here");
  }
}

}  // namespace

void check_images(Asset& asset) {
  const Json& images = asset.list_of("images");
  const Json& textures = asset.list_of("textures");
  std::vector<std::string> types;
  for (size_t i = 0; i < std::min<size_t>(images.size(), asset.file.limits().images); ++i) {
    types.push_back(ImageCheck(asset, i).check());
    for (const auto& [type, extension] :
         {std::pair{"image/webp", "EXT_texture_webp"}, {"image/ktx2", "KHR_texture_basisu"}})
      if (types.back() == type && !asset.uses_extension(extension))
        asset.add(path_to("images", i),
                  std::string(type) + " needs " + extension + " in extensionsUsed");
  }
  for (size_t i = 0; i < textures.size(); ++i)
    check_texture(asset, textures[i], types, path_to("textures", i));
}

}  // namespace lueur::conformance
