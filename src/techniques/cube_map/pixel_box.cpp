// SPDX-License-Identifier: MIT
#include "techniques/cube_map/pixel_box.h"

#include <glm/gtc/type_ptr.hpp>

namespace lueur::cube_map {

PixelBox pixels_of_box(const Box& box, const View& view, Extent extent) {
  const glm::ivec2 size(extent.width, extent.height);
  const glm::mat4 clip_from_world =
      glm::make_mat4(view.clip_from_view.data()) * glm::make_mat4(view.view_from_world.data());
  glm::vec2 low(1e30f), high(-1e30f);
  for (int corner = 0; corner < 8; ++corner) {
    glm::vec4 world(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<size_t>(axis);
      world[axis] = (corner >> axis & 1) != 0 ? box.max[i] : box.min[i];
    }
    const glm::vec4 clip = clip_from_world * world;
    if (clip.w < 1e-4f) return {{0, 0}, size};
    const glm::vec2 at_px = (0.5f * glm::vec2(clip) / clip.w + 0.5f) * glm::vec2(size);
    low = glm::min(low, at_px);
    high = glm::max(high, at_px);
  }
  // A pixel more, as rounding moves vertices.
  const glm::vec2 most(size);
  return {glm::ivec2(glm::clamp(glm::floor(low) - 1.0f, glm::vec2(0.0f), most)),
          glm::ivec2(glm::clamp(glm::ceil(high) + 1.0f, glm::vec2(0.0f), most))};
}

}  // namespace lueur::cube_map
