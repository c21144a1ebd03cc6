// SPDX-License-Identifier: MIT
#include "reference/camera.h"

#include <cmath>

namespace lueur::reference {

PinholeCamera::PinholeCamera(const Camera& camera, const glm::mat4& world_from_node, uint32_t width,
                             uint32_t height)
    : width_(static_cast<float>(width)),
      height_(static_cast<float>(height)),
      near_m_(camera.near_m) {
  const glm::mat4 world = world_from_camera(world_from_node);
  eye_ = glm::vec3(world[3]);
  axis_ = -glm::vec3(world[2]);
  const float pixel = 2.0f * std::tan(0.5f * camera.vertical_fov_rad) / height_;
  step_x_ = pixel * glm::vec3(world[0]);
  step_y_ = -pixel * glm::vec3(world[1]);
  corner_ = axis_ - 0.5f * width_ * step_x_ - 0.5f * height_ * step_y_;
}

Ray PinholeCamera::ray_through(glm::vec2 position_px) const {
  const glm::vec3 direction = corner_ + position_px.x * step_x_ + position_px.y * step_y_;
  return {eye_ + near_m_ * direction, direction};
}

bool PinholeCamera::in_view(const glm::vec3& point) const {
  const glm::vec3 to_point = point - eye_;
  const float z = glm::dot(to_point, axis_);
  if (z < near_m_) return false;
  const glm::vec3 on_plane = to_point / z - corner_;
  const float x = glm::dot(on_plane, step_x_) / glm::dot(step_x_, step_x_);
  const float y = glm::dot(on_plane, step_y_) / glm::dot(step_y_, step_y_);
  return x >= 0.0f && y >= 0.0f && x <= width_ && y <= height_;
}

}  // namespace lueur::reference
