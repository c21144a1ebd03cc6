// SPDX-License-Identifier: MIT
#include "scene/obj_texture.h"

#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "base/try.h"
#include "scene/gltf_uri.h"

namespace lueur {
namespace {

// Rec.709 luma, in 256ths.
uint8_t luma(const uint8_t* rgba) {
  return static_cast<uint8_t>((rgba[0] * 54u + rgba[1] * 183u + rgba[2] * 19u) >> 8);
}

// One channel of a picture, read at places of a texture that may be of another size.
class ChannelView {
 public:
  ChannelView(const EncodedImage& image, char channel) : image_(&image), channel_(channel) {}

  uint8_t at(uint32_t x, uint32_t y, uint32_t width, uint32_t height) const {
    const uint64_t column = uint64_t{x} * image_->header.width / width;
    const uint64_t row = uint64_t{y} * image_->header.height / height;
    const uint8_t* rgba = image_->rgba.data() + (row * image_->header.width + column) * 4;
    switch (channel_) {
      case 'r':
        return rgba[0];
      case 'g':
        return rgba[1];
      case 'b':
        return rgba[2];
      case 'm':
        return rgba[3];
      default:
        return luma(rgba);
    }
  }

 private:
  const EncodedImage* image_;
  char channel_;
};

bool has_alpha(const EncodedImage& image) {
  for (size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return true;
  return false;
}

bool is_grey(const EncodedImage& image) {
  constexpr int kJpegNoise = 3;
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    const int r = image.rgba[i], g = image.rgba[i + 1], b = image.rgba[i + 2];
    if (std::abs(r - g) > kJpegNoise || std::abs(g - b) > kJpegNoise) return false;
  }
  return true;
}

uint8_t unorm8(float value) {
  return static_cast<uint8_t>(std::lround((std::clamp(value, -1.0f, 1.0f) * 0.5f + 0.5f) * 255.0f));
}

// Slopes by central differences, across the edges as the texture wraps.
std::vector<uint8_t> normals_of_heights(const EncodedImage& image, float bump, bool clamp) {
  const uint32_t width = image.header.width, height = image.header.height;
  std::vector<float> heights(size_t{width} * height);
  for (size_t i = 0; i < heights.size(); ++i)
    heights[i] = static_cast<float>(luma(image.rgba.data() + i * 4)) / 255.0f;
  const auto before = [&](uint32_t i, uint32_t n) { return i > 0 ? i - 1 : clamp ? 0 : n - 1; };
  const auto after = [&](uint32_t i, uint32_t n) { return i + 1 < n ? i + 1 : clamp ? i : 0; };
  std::vector<uint8_t> rgba(image.rgba.size(), 255);
  for (uint32_t y = 0; y < height; ++y) {
    const float* row = heights.data() + size_t{y} * width;
    const float* above = heights.data() + size_t{before(y, height)} * width;
    const float* below = heights.data() + size_t{after(y, height)} * width;
    for (uint32_t x = 0; x < width; ++x) {
      const glm::vec3 normal =
          glm::normalize(glm::vec3(0.5f * bump * (row[before(x, width)] - row[after(x, width)]),
                                   0.5f * bump * (below[x] - above[x]), 1.0f));
      uint8_t* out = rgba.data() + (size_t{y} * width + x) * 4;
      for (int i = 0; i < 3; ++i) out[i] = unorm8(normal[i]);
    }
  }
  return rgba;
}

uint64_t bytes_of(const ImageHeader& header) {
  return uint64_t{header.width} * header.height * 4;
}

}  // namespace

Result<int32_t> ObjTextures::image(const MtlMap& map) {
  const auto [entry, is_new] = image_of_file_.try_emplace(map.file, kNone);
  if (!is_new) return entry->second;
  const auto at = map.place + ": ";
  const auto path = confined_file(folder_, map.file);
  std::error_code failure;
  if (!path.ok() || !std::filesystem::exists(*path, failure)) {
    warnings_->add(
        at + (path.ok() ? "'" + path->filename().string() + "' is missing" : path.error().message) +
        ": drawn without this texture");
    return kNone;
  }
  if (images_.size() >= limits_->images)
    return Error{ErrorKind::input, at + "more than " + std::to_string(limits_->images) +
                                       " pictures are in use; merge some into atlases"};
  LUEUR_TRY(bytes, read_file(*path, limits_->file_bytes - bytes_read_));
  bytes_read_ += bytes.size();
  EncodedImage image;
  image.name = path->filename().string();
  image.path = path->string() + ": ";
  image.storage = std::move(bytes);
  image.bytes = image.storage;
  if (const auto checked = read_header(image, *limits_); !checked.ok())
    return Error{checked.error().kind, image.path + checked.error().message};
  pixel_bytes_ += bytes_of(image.header);
  entry->second = static_cast<int32_t>(images_.size());
  images_.push_back(std::move(image));
  return entry->second;
}

Result<int32_t> ObjTextures::note(const Recipe& recipe) {
  const auto [entry, is_new] =
      place_of_recipe_.try_emplace(recipe, static_cast<int32_t>(recipes_.size()));
  if (!is_new) return entry->second;
  recipes_.push_back(recipe);
  // What is made takes as much as the larger of what it is made from, on each side.
  ImageHeader size;
  for (const int32_t source : {recipe.first, recipe.second}) {
    if (source == kNone) continue;
    const EncodedImage& image = images_[static_cast<size_t>(source)];
    size.width = std::max(size.width, image.header.width);
    size.height = std::max(size.height, image.header.height);
  }
  pixel_bytes_ += bytes_of(size);
  if (pixel_bytes_ > limits_->texture_bytes)
    return Error{ErrorKind::input, folder_.string() + ": all textures together take more than " +
                                       std::to_string(limits_->texture_bytes) +
                                       " bytes; resize them"};
  return entry->second;
}

Result<int32_t> ObjTextures::picture(const MtlMap& map) {
  LUEUR_TRY(first, image(map));
  if (first == kNone) return kNone;
  return note({.kind = Kind::picture, .first = first, .clamp = map.clamp});
}

Result<int32_t> ObjTextures::cut_out(const MtlMap* color, const MtlMap& alpha) {
  LUEUR_TRY(second, image(alpha));
  if (second == kNone) return color ? picture(*color) : Result<int32_t>(kNone);
  int32_t first = kNone;
  if (color) {
    LUEUR_TRY(found, image(*color));
    first = found;
  }
  return note({.kind = Kind::cut_out,
               .first = first,
               .second = second,
               .second_channel = alpha.channel,
               .clamp = color ? color->clamp : alpha.clamp});
}

Result<int32_t> ObjTextures::metallic_roughness(const MtlMap* roughness, const MtlMap* metallic) {
  Recipe recipe{.kind = Kind::metallic_roughness};
  if (roughness) {
    LUEUR_TRY(first, image(*roughness));
    recipe.first = first;
    recipe.first_channel = roughness->channel;
    recipe.clamp = roughness->clamp;
  }
  if (metallic) {
    LUEUR_TRY(second, image(*metallic));
    recipe.second = second;
    recipe.second_channel = metallic->channel;
    recipe.clamp = recipe.clamp || metallic->clamp;
  }
  if (recipe.first == kNone && recipe.second == kNone) return kNone;
  return note(recipe);
}

Result<int32_t> ObjTextures::bumps(const MtlMap& map) {
  LUEUR_TRY(first, image(map));
  if (first == kNone) return kNone;
  return note({.kind = Kind::bumps, .first = first, .clamp = map.clamp, .bump = map.bump});
}

Texture ObjTextures::made(const Recipe& recipe) const {
  const EncodedImage* first =
      recipe.first == kNone ? nullptr : &images_[static_cast<size_t>(recipe.first)];
  const EncodedImage* second =
      recipe.second == kNone ? nullptr : &images_[static_cast<size_t>(recipe.second)];
  Texture texture;
  texture.name = (first ? first : second)->name;
  texture.width = std::max(first ? first->header.width : 1, second ? second->header.width : 1);
  texture.height = std::max(first ? first->header.height : 1, second ? second->header.height : 1);
  texture.wrap_u = texture.wrap_v = recipe.clamp ? Wrap::clamp_to_edge : Wrap::repeat;
  if (recipe.kind == Kind::picture || (recipe.kind == Kind::bumps && !is_grey(*first))) {
    texture.rgba = first->rgba;
    return texture;
  }
  if (recipe.kind == Kind::bumps) {
    texture.rgba = normals_of_heights(*first, recipe.bump, recipe.clamp);
    return texture;
  }

  // Put channels of two pictures together.
  texture.rgba.assign(size_t{texture.width} * texture.height * 4, 255);
  const bool cuts = recipe.kind == Kind::cut_out;
  const char second_channel = recipe.second_channel != 0 || !cuts ? recipe.second_channel
                              : has_alpha(*second)                ? 'm'
                                                                  : 'l';
  for (uint32_t y = 0; y < texture.height; ++y) {
    for (uint32_t x = 0; x < texture.width; ++x) {
      uint8_t* out = texture.rgba.data() + (size_t{y} * texture.width + x) * 4;
      const auto read = [&](const EncodedImage& image, char channel) {
        return ChannelView(image, channel).at(x, y, texture.width, texture.height);
      };
      if (cuts) {
        for (int i = 0; first && i < 3; ++i) out[i] = read(*first, "rgb"[i]);
        out[3] = read(*second, second_channel);
      } else {
        if (first) out[1] = read(*first, recipe.first_channel);
        if (second) out[2] = read(*second, second_channel);
      }
    }
  }
  return texture;
}

Result<std::vector<Texture>> ObjTextures::make() {
  LUEUR_TRY_VOID(decode_all(images_));
  std::vector<Texture> textures;
  for (const Recipe& recipe : recipes_) textures.push_back(made(recipe));
  return textures;
}

}  // namespace lueur
