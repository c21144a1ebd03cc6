// SPDX-License-Identifier: MIT
#include "image/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
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

// Averages 2 x 2 texels of `from`; the last row or column of an odd size stays out, unless it is
// the only one.
MipLevel halved(const uint8_t* from, uint32_t width, uint32_t height, bool srgb) {
  static const SrgbTables kTables;
  MipLevel to{std::max(width / 2, 1u), std::max(height / 2, 1u), {}};
  to.rgba.resize(size_t{to.width} * to.height * 4);
  uint8_t* out = to.rgba.data();
  for (uint32_t y = 0; y < to.height; ++y) {
    for (uint32_t x = 0; x < to.width; ++x, out += 4) {
      const uint32_t x0 = std::min(2 * x, width - 1);
      const uint32_t x1 = std::min(2 * x + 1, width - 1);
      const uint32_t y0 = std::min(2 * y, height - 1);
      const uint32_t y1 = std::min(2 * y + 1, height - 1);
      const uint8_t* texels[4] = {
          from + 4 * (size_t{y0} * width + x0), from + 4 * (size_t{y0} * width + x1),
          from + 4 * (size_t{y1} * width + x0), from + 4 * (size_t{y1} * width + x1)};
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
  return to;
}

}  // namespace

std::vector<MipLevel> make_mip_chain(std::span<const uint8_t> rgba, uint32_t width, uint32_t height,
                                     bool srgb) {
  LUEUR_CHECK_OP(rgba.size(), ==, size_t{width} * height * 4);
  std::vector<MipLevel> levels;
  const uint8_t* finer = rgba.data();
  while (width > 1 || height > 1) {
    levels.push_back(halved(finer, width, height, srgb));
    width = levels.back().width;
    height = levels.back().height;
    finer = levels.back().rgba.data();
  }
  return levels;
}

}  // namespace lueur
