// SPDX-License-Identifier: MIT
#include "renderer/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/tone_map.h"

namespace lueur {
namespace {

constexpr size_t kEncodeSteps = 65536;

// sRGB to light and back by tables: a texture has millions of texels.
struct SrgbTables {
  std::array<float, 256> decode{};
  std::array<uint8_t, kEncodeSteps + 1> encode{};
  SrgbTables() {
    for (size_t i = 0; i < decode.size(); ++i)
      decode[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
    // Indexed by the square root of the light, which spreads dark values over more steps.
    for (size_t i = 0; i < encode.size(); ++i) {
      const float root = static_cast<float>(i) / static_cast<float>(kEncodeSteps);
      encode[i] = static_cast<uint8_t>(std::lround(srgb_from_linear(root * root) * 255.0f));
    }
  }
};

void halve(const uint8_t* from, Extent from_extent, uint8_t* to, Extent to_extent, bool srgb) {
  static const SrgbTables kTables;
  for (uint32_t y = 0; y < to_extent.height; ++y) {
    for (uint32_t x = 0; x < to_extent.width; ++x) {
      const uint32_t x0 = std::min(2 * x, from_extent.width - 1);
      const uint32_t x1 = std::min(2 * x + 1, from_extent.width - 1);
      const uint32_t y0 = std::min(2 * y, from_extent.height - 1);
      const uint32_t y1 = std::min(2 * y + 1, from_extent.height - 1);
      const uint8_t* texels[4] = {from + 4 * (size_t{y0} * from_extent.width + x0),
                                  from + 4 * (size_t{y0} * from_extent.width + x1),
                                  from + 4 * (size_t{y1} * from_extent.width + x0),
                                  from + 4 * (size_t{y1} * from_extent.width + x1)};
      uint8_t* out = to + 4 * (size_t{y} * to_extent.width + x);
      for (int c = 0; c < 4; ++c) {
        if (srgb && c < 3) {
          const float light = 0.25f * (kTables.decode[texels[0][c]] + kTables.decode[texels[1][c]] +
                                       kTables.decode[texels[2][c]] + kTables.decode[texels[3][c]]);
          out[c] =
              kTables.encode[static_cast<size_t>(std::lround(std::sqrt(light) * kEncodeSteps))];
        } else {
          out[c] = static_cast<uint8_t>(
              (texels[0][c] + texels[1][c] + texels[2][c] + texels[3][c] + 2) / 4);
        }
      }
    }
  }
}

}  // namespace

MipChain make_mip_chain(const std::vector<uint8_t>& rgba, Extent extent, bool srgb) {
  MipChain chain;
  chain.extents.push_back(extent);
  const uint8_t* finer = rgba.data();
  while (chain.extents.back().width > 1 || chain.extents.back().height > 1) {
    const Extent from = chain.extents.back();
    const Extent to{std::max(from.width / 2, 1u), std::max(from.height / 2, 1u)};
    std::vector<uint8_t> level(size_t{to.width} * to.height * 4);
    halve(finer, from, level.data(), to, srgb);
    chain.extents.push_back(to);
    chain.levels.push_back(std::move(level));
    finer = chain.levels.back().data();
  }
  return chain;
}

}  // namespace lueur
