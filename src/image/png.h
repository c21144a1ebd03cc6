// SPDX-License-Identifier: MIT
// PNG files. Samples pass through unchanged: embedded gamma, chromaticities and colour profiles are
// ignored, as glTF 2.0 asks for its textures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "lueur/result.h"

namespace lueur {

inline constexpr uint32_t kMaxPngSide = 16384;                // pixels
inline constexpr uint64_t kMaxPngPixels = uint64_t{1} << 26;  // 8192 x 8192

// Decodes any kind of PNG (grey, palette or colour, 1 to 16 bits, interlaced or not) to 4 channels
// of 8 bits: grey is repeated, missing alpha is 255, 16 bits are rounded to 8. `name` stands for
// the file in messages. Fails (ErrorKind::input) on anything but a whole, undamaged PNG within the
// limits above; the limits, and whether the data can be that large at all, are checked before
// memory is taken.
Result<Image8> decode_png(std::span<const uint8_t> bytes, const std::string& name);
Result<Image8> read_png(const std::filesystem::path& path);

// Encodes 3 or 4 channels as sRGB; `name` stands for the picture in messages. The same picture
// gives the same bytes. Fails (ErrorKind::output) on an empty picture and on one beyond the limits.
Result<std::vector<uint8_t>> encode_png(const Image8& image, const std::string& name);
// Writes such a file, all or nothing.
Result<void> write_png(const std::filesystem::path& path, const Image8& image);

}  // namespace lueur
