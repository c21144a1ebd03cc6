// SPDX-License-Identifier: MIT
// Takes the picture of a face of a cube map through the engine's own views, and makes the map's
// texels of it: LCM 5.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "frame/recorder.h"
#include "lueur/host.h"

namespace lueur {

struct CubeCapture {
  uint32_t picture_px = 256;  // side of a face's picture
  uint32_t side = 4;          // texels a side that are made of it; divides picture_px
  // Objects of the host that are left out: those that the map lights.
  std::span<const uint32_t> without{};
  // Where what comes from behind all surfaces counts as coming from, and what is farther, too.
  // Metres.
  float far_m = 1000.0f;
};

// rgb is the mean radiance over a texel, that of the background where nothing is, and a the mean
// distance from the eye (not along the optical axis) in metres: of the surfaces that there are, if
// there is no background.
inline constexpr Format kCubeTexelFormat = Format::rgba32f;

// A distance outside of all that is drawn, from wherever in it. Metres.
float far_of(const Box& bounds);

// Writes side x side texels of `view`, a square one, to `texels` from `corner` on. Records the
// engine's passes and `cube_maps.*`. Fails the frame (ErrorKind::usage) where the engine gives no
// view.
void capture_face(Frame& frame, Host& host, const View& view, const CubeCapture& capture,
                  Image texels, glm::ivec2 corner);

}  // namespace lueur
