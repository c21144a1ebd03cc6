// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "lueur/image.h"

namespace lueur {

// All levels of an RGBA image, finest first, each halved (rounded down, at least 1). Colours of
// sRGB images are averaged as light; alpha, and all channels of others, as they are.
struct MipChain {
  std::vector<Extent> extents;
  std::vector<std::vector<uint8_t>> levels;  // from level 1 on; level 0 is the image itself
};
MipChain make_mip_chain(const std::vector<uint8_t>& rgba, Extent extent, bool srgb);

}  // namespace lueur
