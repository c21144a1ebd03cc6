// SPDX-License-Identifier: MIT
// Linear pictures as the page carries them: small, and precise enough for a display at any
// exposure.
#pragma once

#include <cstdint>
#include <string>

#include "image/image.h"

namespace lueur::report {

// A sample is a code: the bits of a half float without its sign and its last kDroppedBits bits,
// rounded to nearest. Codes grow with the value, about 256 for each doubling. Hence a code is off
// by at most 2^-9 of the value, and the half that it came from by 2^-11 (below 2^-14, where halves
// have fewer digits, both together by at most 2^-22).
inline constexpr uint32_t kDroppedBits = 2;

uint16_t picture_code(
    float value);  // NaN and negative values count as 0; the largest code is finite

struct PackedPicture {
  std::string base64;     // of a zlib stream
  uint64_t replaced = 0;  // samples that were NaN, infinite or negative
};

// Packs an image of 1 or 3 channels. Green (or the only channel) is predicted from the codes to the
// left, above and above left; red and blue are green plus a difference that is predicted likewise,
// since light of one colour varies together. What prediction misses is stored with its sign in the
// last bit, channel by channel (green, red, blue), first all low bytes, then all high bytes, and
// deflated. The page's page/packed_picture.js undoes this.
PackedPicture pack_picture(const ImageF& image);

}  // namespace lueur::report
