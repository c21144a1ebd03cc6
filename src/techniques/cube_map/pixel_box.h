// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include "lueur/host.h"

namespace lueur::cube_map {

// first <= pixel < end.
struct PixelBox {
  glm::ivec2 first{0};
  glm::ivec2 end{0};
  bool is_empty() const { return first.x >= end.x || first.y >= end.y; }
};

// The pixels that may show something of the box; all of them where it reaches behind the eye.
PixelBox pixels_of_box(const Box& box, const View& view, Extent extent);

}  // namespace lueur::cube_map
