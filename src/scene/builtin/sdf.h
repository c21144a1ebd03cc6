// SPDX-License-Identifier: MIT
// Signed distances (metres, negative inside) to simple solids, and ways to join them, for sculpting
// with isosurface.h. None changes by more than a metre a metre, unless said otherwise; nor do the
// joins then. Distances may be too short where a comment says "bound", never too long.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace lueur::builtin::sdf {

inline float sphere(glm::vec3 p, glm::vec3 center, float radius) {
  return glm::distance(p, center) - radius;
}

// Bound. Axes along x, y, z.
inline float ellipsoid(glm::vec3 p, glm::vec3 center, glm::vec3 radii) {
  const float smallest = std::min({radii.x, radii.y, radii.z});
  return (glm::length((p - center) / radii) - 1.0f) * smallest;
}

// Where on the segment from a to b the point nearest to p lies: 0 at a, 1 at b.
inline float segment_share(glm::vec3 p, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 along = b - a;
  return std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0f, 1.0f);
}

inline float capsule(glm::vec3 p, glm::vec3 a, glm::vec3 b, float radius) {
  return glm::distance(p, glm::mix(a, b, segment_share(p, a, b))) - radius;
}

// A rod from a to b whose radius changes evenly. Steeper than 1 by |radius_b - radius_a| / length.
inline float cone(glm::vec3 p, glm::vec3 a, glm::vec3 b, float radius_a, float radius_b) {
  const float share = segment_share(p, a, b);
  return glm::distance(p, glm::mix(a, b, share)) - glm::mix(radius_a, radius_b, share);
}

// Edges are rounded by `rounding`, within the half size.
inline float box(glm::vec3 p, glm::vec3 center, glm::vec3 half_size, float rounding = 0.0f) {
  const glm::vec3 q = glm::abs(p - center) - (half_size - rounding);
  return glm::length(glm::max(q, 0.0f)) + std::min(std::max({q.x, q.y, q.z}), 0.0f) - rounding;
}

// A ring in the plane through `center` whose normal is the unit vector `axis`.
inline float torus(glm::vec3 p, glm::vec3 center, glm::vec3 axis, float radius, float tube_radius) {
  const glm::vec3 from_center = p - center;
  const float height = glm::dot(from_center, axis);
  return glm::length(glm::vec2(glm::length(from_center - axis * height) - radius, height)) -
         tube_radius;
}

// The union, with a fillet about `width` wide where both are near; never larger than the union.
inline float smooth_min(float a, float b, float width) {
  const float near = std::max(width - std::abs(a - b), 0.0f) / width;
  return std::min(a, b) - near * near * width * 0.25f;
}

// The intersection, rounded alike; smooth_max(a, -b, width) takes b away from a.
inline float smooth_max(float a, float b, float width) {
  return -smooth_min(-a, -b, width);
}

}  // namespace lueur::builtin::sdf
