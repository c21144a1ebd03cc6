// SPDX-License-Identifier: MIT
// Radiance pictures (.hdr, .pic): colours of 8 bits with an exponent that the three share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "image/image.h"
#include "lueur/result.h"

namespace lueur {

inline constexpr uint32_t kMaxHdrSide = 16384;                // pixels
inline constexpr uint64_t kMaxHdrPixels = uint64_t{1} << 26;  // 768 MiB of floats

// Reads a picture with three channels, rows from the top left. Scan lines may be flat or of either
// run-length encoding, and run along any of the eight orders of axes. What EXPOSURE and COLORCORR
// in the header say was multiplied in is divided out again, so that the samples are radiance in the
// file's unit. Fails (ErrorKind::input) on colours as XYZE, on sizes beyond the limits and on files
// that are damaged or cut short; the header is checked before memory is taken. `name` stands for
// the file in messages.
Result<ImageF> decode_hdr(std::span<const uint8_t> bytes, const std::string& name);
Result<ImageF> read_hdr(const std::filesystem::path& path);

// Whether the bytes begin as such a file.
bool is_hdr(std::span<const uint8_t> bytes);

}  // namespace lueur
