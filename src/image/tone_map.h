// SPDX-License-Identifier: MIT
// From scene-referred light to the code values of a display.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "image/image.h"

namespace lueur {

// All curves take linear Rec.709 in which 1 is the white of the display.
enum class ToneMap : uint8_t {
  none,  // clamps each channel to [0, 1]; what is below white is shown as it is
  aces,  // Stephen Hill's fit of the ACES 1.0 RRT and sRGB ODT
  agx,   // Troy Sobotka's AgX, base look, with Benjamin Wrensch's polynomial for its curve
  khronos_neutral,  // Khronos PBR Neutral 1.0: keeps base colours up to 0.8, compresses above
};

struct ToneMapName {
  std::string_view name;  // as it is given on the command line
  ToneMap tone_map;
  std::string_view summary;
};

inline constexpr std::array<ToneMapName, 4> kToneMapNames = {{
    {"none", ToneMap::none, "clamp to white"},
    {"aces", ToneMap::aces, "filmic: ACES 1.0, fit by Stephen Hill"},
    {"agx", ToneMap::agx, "filmic with a soft path to white: AgX by Troy Sobotka"},
    {"khronos-neutral", ToneMap::khronos_neutral, "true base colours: Khronos PBR Neutral"},
}};

// The IEC 61966-2-1 transfer function, piecewise; `linear` in [0, 1] gives a value in [0, 1].
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

// Multiplies the colours by 2^exposure_ev, applies the curve, encodes as sRGB and rounds to the
// nearest code value, without dither. `image` has 1 channel (becomes grey), 3, or 4; the fourth is
// coverage in [0, 1], which is only clamped and rounded. The picture returned has 3 channels, or 4
// when `image` has. A sample that is NaN or negative counts as 0, one of more than 65504 after
// exposure (infinity included) as 65504; no input gives anything but finite, repeatable values.
Image8 to_display(const ImageF& image, float exposure_ev, ToneMap tone_map);

}  // namespace lueur
