// SPDX-License-Identifier: MIT
// PNG and JPEG bytes to 8-bit RGBA. Colour profiles and gamma tags are ignored, as glTF demands.
#pragma once

#include <cstdint>
#include <span>

#include "lueur/result.h"

namespace lueur {

enum class ImageFormat : uint8_t { png, jpeg };

struct ImageHeader {
  ImageFormat format = ImageFormat::png;
  uint32_t width = 0;
  uint32_t height = 0;
};

// Reads the size without decoding. Fails on other formats (naming the ones it knows) and on damaged
// headers. Messages name what is wrong but not the place; the caller does.
Result<ImageHeader> read_image_header(std::span<const uint8_t> bytes);

// Decodes into `rgba`, width * height * 4 bytes of `header`, rows from the top. Fails on damaged
// and truncated data. May be called from several threads at once.
Result<void> decode_image(std::span<const uint8_t> bytes, const ImageHeader& header,
                          std::span<uint8_t> rgba);

}  // namespace lueur
