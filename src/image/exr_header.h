// SPDX-License-Identifier: MIT
// A first look at an EXR header, on our own, before the library sees the file. The library believes
// the sizes it finds there and takes memory for them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lueur/result.h"

namespace lueur {

struct ExrHeader {
  int32_t min_x = 0;
  int32_t min_y = 0;
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t channels = 0;
};

// The error of a file that cannot be used. `reason` may hold text from the file: what is not
// printable becomes "?".
Error bad_exr(const std::string& name, std::string reason);

// Walks over the attributes and accepts only what read_exr promises to read: a scan-line file of
// one part within the limits of exr.h, whose attributes and offset table lie inside the file,
// without subsampling, in a compression that is safe to decode.
Result<ExrHeader> check_exr_header(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace lueur
