// SPDX-License-Identifier: MIT
// The renderer's camera: from a pixel to a ray, and from a point to where it is seen.
#pragma once

#include <glm/glm.hpp>

#include "reference/ray_scene.h"

namespace lueur::reference {

class PinholeCamera {
 public:
  PinholeCamera(const Camera& camera, const glm::mat4& world_from_node, uint32_t width,
                uint32_t height);

  // Through the position (x, y) in pixels; the centre of the first is (0.5, 0.5). The ray starts on
  // the near plane, and distances along it, plus near_m(), are along the optical axis.
  Ray ray_through(glm::vec2 position_px) const;
  float near_m() const { return near_m_; }
  glm::vec3 eye() const { return eye_; }
  // Whether the point lies within the picture and beyond the near plane.
  bool in_view(const glm::vec3& point) const;

  // The direction of ray_through(p) is corner() + p.x * step_x() + p.y * step_y(); one unit along
  // the optical axis.
  glm::vec3 step_x() const { return step_x_; }
  glm::vec3 step_y() const { return step_y_; }
  // Area of a pixel on the plane at distance 1: |s_x s_y| of HSSIL (2).
  float pixel_area() const { return glm::length(step_x_) * glm::length(step_y_); }
  glm::vec3 axis() const { return axis_; }

 private:
  glm::vec3 eye_, axis_, corner_, step_x_, step_y_;
  float width_, height_, near_m_;
};

}  // namespace lueur::reference
