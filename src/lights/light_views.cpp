// SPDX-License-Identifier: MIT
#include "lights/light_views.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "lights/square_views.h"

namespace lueur {
namespace {

constexpr float kWidestSingleView = std::numbers::pi_v<float> / 3.0f;  // half angle
// A directional light's view stands off by this many radii of the scene: the rays of a view through
// the whole scene differ by 1/50 from parallel ones.
constexpr float kRadiiAway = 50.0f;

glm::vec3 as_vec3(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

std::vector<View> views_of_light(const PunctualLight& light, const Box& bounds) {
  const glm::vec3 eye = as_vec3(light.position);
  switch (light.kind) {
    case PunctualLight::Kind::point:
      return cube_views(eye);
    case PunctualLight::Kind::spot: {
      const ViewAxes axes = axes_along(as_vec3(light.direction));
      if (light.outer_cone_rad > kWidestSingleView)
        return cube_views(eye, axes, light.outer_cone_rad);
      // A little more than the cone, so that its edge is inside.
      const float half_width = std::tan(light.outer_cone_rad * 1.02f);
      return {square_view(eye, axes, half_width, kCubeViewNearM)};
    }
    case PunctualLight::Kind::directional: {
      const ViewAxes axes = axes_along(as_vec3(light.direction));
      const glm::vec3 low = as_vec3(bounds.min), high = as_vec3(bounds.max);
      const glm::vec3 middle = 0.5f * (low + high);
      const float radius_m = std::max(0.5f * glm::length(high - low), 1e-3f);
      const float distance_m = kRadiiAway * radius_m;
      const float half_width = 1.0f / std::sqrt(kRadiiAway * kRadiiAway - 1.0f);
      return {square_view(middle - distance_m * axes.forward, axes, half_width,
                          distance_m - 1.1f * radius_m)};
    }
  }
  return {};
}

}  // namespace lueur
