// SPDX-License-Identifier: MIT
#include "scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lueur {
namespace {

using glm::dvec2;

// Positive if a, b, c turn to the left.
double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The corners along the axis that the normal is closest to, counter-clockwise.
std::vector<dvec2> flattened(std::span<const glm::vec3> corners) {
  const glm::dvec3 normal = area_vector(corners);
  const glm::dvec3 size = glm::abs(normal);
  const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int x = (drop + 1) % 3, y = (drop + 2) % 3;
  const double side = normal[drop] < 0.0 ? -1.0 : 1.0;
  std::vector<dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::vec3& corner : corners)
    flat.emplace_back(double{corner[x]}, side * double{corner[y]});
  return flat;
}

// What is left of a polygon while ears are cut off it.
class Outline {
 public:
  explicit Outline(std::vector<dvec2> points) : points_(std::move(points)) {
    const size_t n = points_.size();
    before_.resize(n);
    after_.resize(n);
    for (size_t i = 0; i < n; ++i) {
      before_[i] = static_cast<uint32_t>((i + n - 1) % n);
      after_[i] = static_cast<uint32_t>((i + 1) % n);
    }
  }

  uint32_t before(uint32_t i) const { return before_[i]; }
  uint32_t after(uint32_t i) const { return after_[i]; }
  double turn_at(uint32_t i) const {
    return turn(points_[before_[i]], points_[i], points_[after_[i]]);
  }
  void remove(uint32_t i) {
    after_[before_[i]] = after_[i];
    before_[after_[i]] = before_[i];
  }

  // Whether the triangle at `i` holds no other part of the polygon.
  bool is_ear(uint32_t i) const {
    const dvec2 &a = points_[before_[i]], &b = points_[i], &c = points_[after_[i]];
    if (!(turn(a, b, c) > 0.0)) return false;
    for (uint32_t k = after_[after_[i]]; k != before_[i]; k = after_[k]) {
      const dvec2& p = points_[k];
      // Corners in the same place belong to a double edge. Only inner corners reach in.
      if (p == a || p == b || p == c || turn_at(k) > 0.0) continue;
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
  }

 private:
  std::vector<dvec2> points_;
  std::vector<uint32_t> before_, after_;
};

bool is_convex(const std::vector<dvec2>& points) {
  const size_t n = points.size();
  size_t falls = 0;  // of x: a convex outline has one run of them
  for (size_t i = 0; i < n; ++i) {
    const dvec2 &a = points[i], &b = points[(i + 1) % n], &c = points[(i + 2) % n];
    if (turn(a, b, c) < 0.0) return false;
    if (b.x >= a.x && c.x < b.x) ++falls;
  }
  return falls <= 1;
}

}  // namespace

glm::dvec3 area_vector(std::span<const glm::vec3> corners) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin(corners[0]);
  for (size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
  return sum;
}

bool triangulate(std::span<const glm::vec3> corners, std::vector<uint32_t>& triangles) {
  const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
    triangles.insert(triangles.end(), {a, b, c});
  };
  const uint32_t count = static_cast<uint32_t>(corners.size());
  if (count == 3) {
    add(0, 1, 2);
    return true;
  }
  std::vector<dvec2> flat = flattened(corners);
  if (is_convex(flat)) {
    for (uint32_t i = 1; i + 1 < count; ++i) add(0, i, i + 1);
    return true;
  }

  // Cut off ears, going round. A whole round without one comes of outlines that cross themselves:
  // then the rest is a fan, as to search on could take very long.
  Outline outline(std::move(flat));
  uint32_t at = 0, left = count, without_ear = 0;
  while (left > 3 && without_ear <= left) {
    const uint32_t next = outline.after(at);
    const bool is_flat = outline.turn_at(at) == 0.0;
    if (!is_flat && !outline.is_ear(at)) {
      ++without_ear;
      at = next;
      continue;
    }
    if (!is_flat) add(outline.before(at), at, next);
    outline.remove(at);
    --left;
    without_ear = 0;
    // Step over the next corner: triangles become less thin than in a fan.
    at = outline.after(next);
  }
  for (uint32_t k = outline.after(at); outline.after(k) != at; k = outline.after(k))
    if (left > 3 || outline.turn_at(at) != 0.0) add(at, k, outline.after(k));
  return left <= 3;
}

}  // namespace lueur
