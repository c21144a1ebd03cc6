// SPDX-License-Identifier: MIT
#include "reference/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/tone_map.h"

namespace lueur::reference {
namespace {

// Light by code value: each sRGB texel is decoded before it is filtered, as the hardware does.
std::array<float, 256> make_decode_table() {
  std::array<float, 256> table{};
  for (size_t i = 0; i < table.size(); ++i)
    table[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
  return table;
}
const std::array<float, 256> kDecode = make_decode_table();

int32_t wrapped(int32_t i, int32_t size, Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp_to_edge:
      return std::clamp(i, 0, size - 1);
    case Wrap::repeat: {
      if (static_cast<uint32_t>(i) < static_cast<uint32_t>(size)) return i;
      const int32_t rest = i % size;
      return rest < 0 ? rest + size : rest;
    }
    case Wrap::mirrored_repeat: {
      const int32_t period = 2 * size;
      const int32_t rest = ((i % period) + period) % period;
      return rest < size ? rest : period - 1 - rest;
    }
  }
  return 0;
}

// What lies far out says nothing more and costs precision: whole repeats, or how far beyond the
// edge. What is left fits an int32_t for any texture.
float reduced(float coordinate, Wrap wrap) {
  if (!std::isfinite(coordinate)) return 0.0f;
  if (wrap == Wrap::clamp_to_edge) return std::clamp(coordinate, -1.0f, 2.0f);
  return std::abs(coordinate) > 1024.0f ? std::fmod(coordinate, 2.0f) : coordinate;
}

}  // namespace

TextureSampler::TextureSampler(const Texture& texture, Encoding encoding)
    : smaller_(
          make_mip_chain(texture.rgba, texture.width, texture.height, encoding == Encoding::srgb)),
      encoding_(encoding),
      wrap_u_(texture.wrap_u),
      wrap_v_(texture.wrap_v),
      nearest_(texture.nearest) {
  levels_.push_back({static_cast<int32_t>(texture.width), static_cast<int32_t>(texture.height),
                     texture.rgba.data()});
  for (const MipLevel& level : smaller_)
    levels_.push_back(
        {static_cast<int32_t>(level.width), static_cast<int32_t>(level.height), level.rgba.data()});
}

glm::vec4 TextureSampler::decoded(const uint8_t* t) const {
  if (encoding_ == Encoding::srgb)
    return {kDecode[t[0]], kDecode[t[1]], kDecode[t[2]], static_cast<float>(t[3]) / 255.0f};
  return glm::vec4(t[0], t[1], t[2], t[3]) * (1.0f / 255.0f);
}

glm::vec4 TextureSampler::bilinear(size_t index, glm::vec2 uv) const {
  const Level& level = levels_[index];
  const float x = reduced(uv.x, wrap_u_) * static_cast<float>(level.width);
  const float y = reduced(uv.y, wrap_v_) * static_cast<float>(level.height);
  const auto row = [&](int32_t j) {
    return level.rgba + 4 * static_cast<size_t>(wrapped(j, level.height, wrap_v_)) * level.width;
  };
  const auto column = [&](int32_t i) { return 4 * wrapped(i, level.width, wrap_u_); };
  if (nearest_)
    return decoded(row(static_cast<int32_t>(std::floor(y))) +
                   column(static_cast<int32_t>(std::floor(x))));
  const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
  const float right_share = x - 0.5f - left, bottom_share = y - 0.5f - top;
  const auto i = static_cast<int32_t>(left), j = static_cast<int32_t>(top);
  const uint8_t *row_0 = row(j), *row_1 = row(j + 1);
  const int32_t column_0 = column(i), column_1 = column(i + 1);
  return glm::mix(glm::mix(decoded(row_0 + column_0), decoded(row_0 + column_1), right_share),
                  glm::mix(decoded(row_1 + column_0), decoded(row_1 + column_1), right_share),
                  bottom_share);
}

glm::vec4 TextureSampler::filtered(glm::vec2 uv, glm::vec2 step_x, glm::vec2 step_y) const {
  const glm::vec2 size(levels_[0].width, levels_[0].height);
  const float texels = std::max(glm::length(step_x * size), glm::length(step_y * size));
  const auto coarsest = static_cast<float>(levels_.size() - 1);
  // NaN, of a degenerate triangle, fails the comparison and takes the finest level.
  const float lod = texels > 1.0f ? std::min(std::log2(texels), coarsest) : 0.0f;
  const auto finer = static_cast<size_t>(lod);
  const float share = lod - static_cast<float>(finer);
  const glm::vec4 fine = bilinear(finer, uv);
  return share > 0.0f ? glm::mix(fine, bilinear(finer + 1, uv), share) : fine;
}

glm::vec4 TextureSampler::mean() const {
  return decoded(levels_.back().rgba);
}

}  // namespace lueur::reference
