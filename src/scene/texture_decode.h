// SPDX-License-Identifier: MIT
// Pictures of a scene file on their way to textures: checked by their headers, decoded together.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lueur/result.h"
#include "scene/image_decode.h"
#include "scene/load_limits.h"

namespace lueur {

// A picture still encoded, with where to put it.
struct EncodedImage {
  std::string name;
  std::string path;              // for messages: "file: images[3]: "
  std::vector<uint8_t> storage;  // empty where `bytes` lie elsewhere
  std::span<const uint8_t> bytes;
  ImageHeader header;
  std::vector<uint8_t> rgba;
  std::optional<Error> failure;
};

// Reads the header of `image.bytes`; fails on sizes beyond the limits. The messages do not name the
// place; the caller does.
Result<void> read_header(EncodedImage& image, const LoadLimits& limits);

// Decodes all on all processor cores. Fails with the first damaged one's path and fault. The caller
// has checked what they take together.
Result<void> decode_all(std::vector<EncodedImage>& images);

}  // namespace lueur
