// SPDX-License-Identifier: MIT
// What one scene file may ask for. Readers check it before they take memory.
#pragma once

#include <cstdint>

namespace lueur {

struct LoadLimits {
  uint64_t file_bytes = uint64_t{1} << 30;  // all files of the asset together
  uint64_t vertices = uint64_t{64} << 20;   // all meshes together
  uint64_t indices = uint64_t{64} << 20;
  uint64_t nodes = uint64_t{1} << 20;
  uint64_t images = 4096;
  uint32_t texture_side_px = 16384;
  uint64_t texture_bytes = uint64_t{2} << 30;  // decoded, all textures together
  uint64_t json_values = uint64_t{16} << 20;   // glTF
  uint32_t json_depth = 64;                    // glTF
  uint32_t polygon_corners = 4096;             // OBJ, one polygon
};

}  // namespace lueur
