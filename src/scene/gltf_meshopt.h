// SPDX-License-Identifier: MIT
// Buffer views that are stored compressed: EXT_meshopt_compression.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_json.h"

namespace lueur {

// What a view's extension object promises of its data.
struct MeshoptView {
  enum class Mode : uint8_t { attributes, triangles, indices };
  enum class Filter : uint8_t { none, octahedral, quaternion, exponential };
  Mode mode = Mode::attributes;
  Filter filter = Filter::none;
  uint64_t count = 0;                         // elements
  uint64_t stride = 0;                        // bytes of one
  uint64_t byte_offset = 0, byte_length = 0;  // of the compressed data in their buffer
  int32_t buffer = 0;
  uint64_t decoded_bytes() const { return count * stride; }
};

// Reads and checks the object; `most_bytes` caps what decoding it may take.
Result<MeshoptView> read_meshopt_view(const JsonCursor& at, size_t buffer_count,
                                      uint64_t most_bytes);

// Decodes it; `at` is named where the data are damaged. What comes out may be any bytes.
Result<std::vector<uint8_t>> decode_meshopt(const JsonCursor& at, const MeshoptView& view,
                                            std::span<const uint8_t> compressed);

}  // namespace lueur
