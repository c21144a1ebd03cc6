// SPDX-License-Identifier: MIT
// A camera, and the conventions that hold in the whole library.
//
//   matrices      column-major (element (row r, column c) at [4 * c + r]), for column vectors
//   view space    right-handed: +x right, +y up, the camera looks down -z; metres
//   clip space    Vulkan's: y down, depth 0..1. Reversed z or not follows from the projection
//   image         pixel (0, 0) is the top left one, its centre at (0.5, 0.5)
//   depth         what the projection yields; the cleared value means "nothing here"
//   normal        unit, world space, see Inputs for the encoding
//   radiance      linear Rec.709, scene-referred, in the engine's own unit; Lueur is linear in it
//   motion        in UV: where the point is now minus where it was in the previous frame
#pragma once

#include <array>

namespace lueur {

struct View {
  std::array<float, 16> view_from_world{};
  // Without temporal jitter. A perspective projection; its frustum may be off-centre, near and far
  // plane may be anywhere, infinity included.
  std::array<float, 16> clip_from_view{};
};

}  // namespace lueur
