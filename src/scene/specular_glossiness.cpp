// SPDX-License-Identifier: MIT
#include "scene/specular_glossiness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/tone_map.h"

namespace lueur {
namespace {

constexpr float kDielectric = 0.04f;

float mean(const glm::vec3& v) {
  return (v.x + v.y + v.z) / 3.0f;
}

uint8_t byte_of(float value) {
  return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

// Texels of a texture, or white where there is none, at any resolution.
class Texels {
 public:
  Texels(const TextureUse& use, const std::vector<Texture>& textures)
      : texture_(use.is_used() ? &textures[static_cast<size_t>(use.texture)] : nullptr) {
    for (size_t i = 0; i < linear_.size(); ++i)
      linear_[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
  }
  uint32_t width() const { return texture_ ? texture_->width : 1; }
  uint32_t height() const { return texture_ ? texture_->height : 1; }
  const Texture* texture() const { return texture_; }

  // The nearest texel to pixel (x, y) of a picture of w x h: rgb decoded from sRGB, alpha as it is.
  glm::vec4 at(uint32_t x, uint32_t y, uint32_t w, uint32_t h) const {
    if (!texture_) return glm::vec4(1.0f);
    const uint64_t column = uint64_t{x} * texture_->width / w;
    const uint64_t row = uint64_t{y} * texture_->height / h;
    const uint8_t* texel = &texture_->rgba[(row * texture_->width + column) * 4];
    return {linear_[texel[0]], linear_[texel[1]], linear_[texel[2]], float(texel[3]) / 255.0f};
  }

 private:
  const Texture* texture_;
  std::array<float, 256> linear_{};
};

}  // namespace

MetallicRoughness metallic_roughness_of(const glm::vec3& diffuse, const glm::vec3& specular) {
  const float strongest = std::max({specular.x, specular.y, specular.z});
  const glm::vec3 c = diffuse * (1.0f - std::clamp(strongest, 0.0f, 1.0f));
  const float f0 = mean(specular);
  // No metal reflects as little as a dielectric.
  if (f0 <= kDielectric) return {c, 0.0f, f0 / kDielectric};

  // With x = 1 - m and base = c / x:  0.04 x² - (c + F0) x + c = 0, of which x is the smaller root,
  // here written so that it does not cancel.
  const float sum = mean(c) + f0;
  const float root = std::sqrt(std::max(sum * sum - 4.0f * kDielectric * mean(c), 0.0f));
  const float x = std::clamp(2.0f * mean(c) / (sum + root), 0.0f, 1.0f);
  const float metallic = 1.0f - x;
  // Both equations tell the colour. The specular one counts near metals only: elsewhere the diffuse
  // colour is what one sees, and what light takes on.
  const glm::vec3 by_diffuse = x > 0.0f ? c / x : glm::vec3(0.0f);
  const glm::vec3 by_specular =
      metallic > 0.0f ? (specular - kDielectric * x) / metallic : glm::vec3(0.0f);
  const glm::vec3 base = glm::mix(by_diffuse, by_specular, metallic * metallic);
  return {glm::clamp(base, 0.0f, 1.0f), metallic, 1.0f};
}

bool convert(const SpecularGlossiness& from, Material& material, std::vector<Texture>& textures,
             uint64_t& bytes_left) {
  const Texels diffuse(from.diffuse_texture, textures), specular(from.specular_texture, textures);
  if (!diffuse.texture() && !specular.texture()) {
    const MetallicRoughness found = metallic_roughness_of(glm::vec3(from.diffuse), from.specular);
    material.base_color = glm::vec4(found.base_color, from.diffuse.a);
    material.metallic = found.metallic;
    material.specular = found.specular;
    material.roughness = 1.0f - from.glossiness;
    return true;
  }

  const uint32_t width = std::max(diffuse.width(), specular.width());
  const uint32_t height = std::max(diffuse.height(), specular.height());
  const uint64_t bytes = uint64_t{width} * height * 4;
  if (2 * bytes > bytes_left) return false;
  bytes_left -= 2 * bytes;
  const TextureUse place = diffuse.texture() ? from.diffuse_texture : from.specular_texture;
  const Texture& like = diffuse.texture() ? *diffuse.texture() : *specular.texture();
  Texture base{
      like.name + " as base colour", width, height, {}, like.wrap_u, like.wrap_v, like.nearest};
  Texture mr{like.name + " as metallic and roughness",
             width,
             height,
             {},
             like.wrap_u,
             like.wrap_v,
             like.nearest};
  base.rgba.resize(bytes);
  mr.rgba.resize(bytes);
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const glm::vec4 d = from.diffuse * diffuse.at(x, y, width, height);
      const glm::vec4 s =
          glm::vec4(from.specular, from.glossiness) * specular.at(x, y, width, height);
      const MetallicRoughness found = metallic_roughness_of(glm::vec3(d), glm::vec3(s));
      const size_t at = (size_t{y} * width + x) * 4;
      for (int c = 0; c < 3; ++c)
        base.rgba[at + static_cast<size_t>(c)] = byte_of(srgb_from_linear(found.base_color[c]));
      base.rgba[at + 3] = byte_of(d.a);
      mr.rgba[at + 1] = byte_of(1.0f - s.a);
      mr.rgba[at + 2] = byte_of(found.metallic);
      mr.rgba[at + 3] = 255;
    }
  }
  material.base_color = glm::vec4(1.0f);
  material.metallic = material.roughness = material.specular = 1.0f;
  material.base_color_texture = material.metallic_roughness_texture = place;
  material.base_color_texture.texture = static_cast<int32_t>(textures.size());
  material.metallic_roughness_texture.texture = static_cast<int32_t>(textures.size() + 1);
  textures.push_back(std::move(base));
  textures.push_back(std::move(mr));
  return true;
}

}  // namespace lueur
