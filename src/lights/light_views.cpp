// SPDX-License-Identifier: MIT
#include "lights/light_views.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

namespace lueur {
namespace {

constexpr float kNearM = 0.01f;
constexpr float kWidestSingleView = std::numbers::pi_v<float> / 3.0f;  // half angle
// A directional light's view stands off by this many radii of the scene: the rays of a view through
// the whole scene differ by 1/50 from parallel ones.
constexpr float kRadiiAway = 50.0f;

glm::vec3 as_vec3(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

// Looks along `forward`; `down` is the way of growing rows.
View square_view(const glm::vec3& eye, const glm::vec3& right, const glm::vec3& down,
                 const glm::vec3& forward, float half_width, float near_m) {
  const glm::mat4 world_from_view(glm::vec4(right, 0), glm::vec4(-down, 0), glm::vec4(-forward, 0),
                                  glm::vec4(eye, 1));
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

// Of a view; right x down = forward, as views do not mirror.
struct Axes {
  glm::vec3 right, down, forward;
};

Axes axes_along(const glm::vec3& forward) {
  const glm::vec3 other = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(forward, other));
  return {right, glm::cross(forward, right), forward};
}

// The faces of a cube whose +z face looks along `axes.forward`, as far as a cone around it of this
// half angle reaches them.
std::vector<View> cube_views(const glm::vec3& eye, const Axes& axes, float half_angle_rad) {
  const glm::vec3 x = axes.right, y = axes.down, z = axes.forward;
  const Axes faces[6] = {{-z, y, x}, {z, y, -x}, {x, -z, y}, {x, z, -y}, {x, y, z}, {-x, y, -z}};
  std::vector<View> views;
  for (const Axes& face : faces) {
    // How near to the cone's axis a face comes: 0 for the one ahead, 45 degrees for those at its
    // sides, and for the one behind what is left beyond its corners.
    const float facing = glm::dot(face.forward, z);
    const float nearest = facing > 0.5f ? 0.0f
                          : facing > -0.5f
                              ? 0.25f * std::numbers::pi_v<float>
                              : std::numbers::pi_v<float> - std::atan(std::numbers::sqrt2_v<float>);
    if (nearest < half_angle_rad)
      views.push_back(square_view(eye, face.right, face.down, face.forward, 1.0f, kNearM));
  }
  return views;
}

}  // namespace

std::vector<View> views_of_light(const PunctualLight& light, const Box& bounds) {
  const glm::vec3 eye = as_vec3(light.position);
  switch (light.kind) {
    case PunctualLight::Kind::point:
      return cube_views(eye, axes_along({0, 0, 1}), std::numbers::pi_v<float>);
    case PunctualLight::Kind::spot: {
      const Axes axes = axes_along(as_vec3(light.direction));
      if (light.outer_cone_rad > kWidestSingleView)
        return cube_views(eye, axes, light.outer_cone_rad);
      // A little more than the cone, so that its edge is inside.
      const float half_width = std::tan(light.outer_cone_rad * 1.02f);
      return {square_view(eye, axes.right, axes.down, axes.forward, half_width, kNearM)};
    }
    case PunctualLight::Kind::directional: {
      const Axes axes = axes_along(as_vec3(light.direction));
      const glm::vec3 low = as_vec3(bounds.min), high = as_vec3(bounds.max);
      const glm::vec3 middle = 0.5f * (low + high);
      const float radius_m = std::max(0.5f * glm::length(high - low), 1e-3f);
      const float distance_m = kRadiiAway * radius_m;
      const float half_width = 1.0f / std::sqrt(kRadiiAway * kRadiiAway - 1.0f);
      return {square_view(middle - distance_m * axes.forward, axes.right, axes.down, axes.forward,
                          half_width, distance_m - 1.1f * radius_m)};
    }
  }
  return {};
}

}  // namespace lueur
