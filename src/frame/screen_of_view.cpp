// SPDX-License-Identifier: MIT
#include "frame/screen_of_view.h"

namespace lueur {

Screen screen_of_view(const View& view, Extent extent) {
  const auto at = [&](size_t row, size_t column) { return view.clip_from_view[4 * column + row]; };
  Screen screen{};
  // ndc = p00 * x/z - p02 and p = (ndc + 1) / 2 * W, solved for the ray x/z; y likewise.
  screen.ray_scale = vec2(2.0f / (static_cast<float>(extent.width) * at(0, 0)),
                          2.0f / (static_cast<float>(extent.height) * at(1, 1)));
  screen.ray_offset = vec2((at(0, 2) - 1.0f) / at(0, 0), (at(1, 2) - 1.0f) / at(1, 1));
  // depth = (p22 * -z + p23) / z = p23 / z - p22.
  screen.z_numerator = at(2, 3);
  screen.z_addend = at(2, 2);
  // Depth falls with distance exactly if p23 is positive: reversed z, cleared to 0.
  screen.depth_of_nothing = at(2, 3) > 0.0f ? 0.0f : 1.0f;
  return screen;
}

}  // namespace lueur
