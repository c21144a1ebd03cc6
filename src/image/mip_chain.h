// SPDX-License-Identifier: MIT
// Smaller versions of a texture, as GPUs want them and as filtering on the CPU does.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lueur {

struct MipLevel {
  uint32_t width = 0;         // pixels
  uint32_t height = 0;        // pixels
  std::vector<uint8_t> rgba;  // width * height * 4, rows from the top
};

// The levels below an RGBA image of `width` x `height` pixels, finest first, each halved (rounded
// down, at least 1) until one pixel is left. Colours of sRGB images are averaged as light; alpha,
// and all channels of others, as they are.
std::vector<MipLevel> make_mip_chain(std::span<const uint8_t> rgba, uint32_t width, uint32_t height,
                                     bool srgb);

}  // namespace lueur
