// SPDX-License-Identifier: MIT
// Square views, with reversed z and an infinitely far plane.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "lueur/view.h"

namespace lueur {

// Of a view; right x down = forward, as views do not mirror.
struct ViewAxes {
  glm::vec3 right, down, forward;
};

ViewAxes axes_along(const glm::vec3& forward);

// Looks along `axes.forward`; `axes.down` is the way of growing rows. `half_width` is that of the
// image plane at distance 1.
View square_view(const glm::vec3& eye, const ViewAxes& axes, float half_width, float near_m);

// The faces of a cube whose +z face looks along `axes.forward`, in the order of a Vulkan cube map,
// as far as a cone around it of this half angle reaches them: all six by default.
std::vector<View> cube_views(const glm::vec3& eye, const ViewAxes& axes,
                             float half_angle_rad = 3.14159265f);
// Of a cube that stands as the world does.
std::vector<View> cube_views(const glm::vec3& eye);

inline constexpr float kCubeViewNearM = 0.01f;

}  // namespace lueur
