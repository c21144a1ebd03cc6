// SPDX-License-Identifier: MIT
#include "lights/square_views.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

namespace lueur {

ViewAxes axes_along(const glm::vec3& forward) {
  const glm::vec3 other = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(forward, other));
  return {right, glm::cross(forward, right), forward};
}

View square_view(const glm::vec3& eye, const ViewAxes& axes, float half_width, float near_m) {
  const glm::mat4 world_from_view(glm::vec4(axes.right, 0), glm::vec4(-axes.down, 0),
                                  glm::vec4(-axes.forward, 0), glm::vec4(eye, 1));
  glm::mat4 clip_from_view(0.0f);
  clip_from_view[0][0] = 1.0f / half_width;
  clip_from_view[1][1] = -1.0f / half_width;
  clip_from_view[2][3] = -1.0f;
  clip_from_view[3][2] = near_m;
  View view;
  std::copy_n(glm::value_ptr(glm::inverse(world_from_view)), 16, view.view_from_world.begin());
  std::copy_n(glm::value_ptr(clip_from_view), 16, view.clip_from_view.begin());
  return view;
}

std::vector<View> cube_views(const glm::vec3& eye, const ViewAxes& axes, float half_angle_rad) {
  const glm::vec3 x = axes.right, y = axes.down, z = axes.forward;
  const ViewAxes faces[6] = {{-z, y, x}, {z, y, -x}, {x, -z, y},
                             {x, z, -y}, {x, y, z},  {-x, y, -z}};
  std::vector<View> views;
  for (const ViewAxes& face : faces) {
    // How near to the cone's axis a face comes: 0 for the one ahead, 45 degrees for those at its
    // sides, and for the one behind what is left beyond its corners.
    const float facing = glm::dot(face.forward, z);
    const float nearest = facing > 0.5f ? 0.0f
                          : facing > -0.5f
                              ? 0.25f * std::numbers::pi_v<float>
                              : std::numbers::pi_v<float> - std::atan(std::numbers::sqrt2_v<float>);
    if (nearest < half_angle_rad) views.push_back(square_view(eye, face, 1.0f, kCubeViewNearM));
  }
  return views;
}

std::vector<View> cube_views(const glm::vec3& eye) {
  return cube_views(eye, axes_along({0, 0, 1}));
}

}  // namespace lueur
