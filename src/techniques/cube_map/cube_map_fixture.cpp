// SPDX-License-Identifier: MIT
#include "techniques/cube_map/cube_map_fixture.h"

#include "lights/square_views.h"

namespace lueur {

std::optional<CpuHit> furnace(const glm::dvec3& o, const glm::dvec3& d) {
  const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 16.0;
  const double t = (-b + std::sqrt(b * b - a * c)) / a;
  const glm::dvec3 p = o + t * d;
  return CpuHit{p, -p / 4.0, glm::dvec3(1)};
}

std::optional<CpuHit> room(const glm::dvec3& o, const glm::dvec3& d) {
  std::optional<CpuHit> best;
  double nearest = 1e30;
  const auto plane = [&](const glm::dvec3& n, double at, const glm::dvec3& radiance) {
    const double facing = glm::dot(n, d);
    if (facing >= 0) return;
    const double t = (at - glm::dot(n, o)) / facing;
    if (t <= 1e-9 || t >= nearest) return;
    const glm::dvec3 p = o + t * d;
    if (glm::any(glm::greaterThan(glm::abs(p), glm::dvec3(3.001)))) return;
    nearest = t;
    best = CpuHit{p, n, radiance * (1.5 + std::sin(2 * p.x + p.y))};
  };
  plane({0, 1, 0}, -2, {0.7, 0.7, 0.6});
  plane({0, -1, 0}, -2, {0.5, 0.5, 0.5});
  plane({0, 0, 1}, -3, {0.6, 0.6, 0.7});
  plane({1, 0, 0}, -3, {0.7, 0.2, 0.1});
  plane({-1, 0, 0}, -3, {0.1, 0.6, 0.2});
  return best;
}

std::optional<double> meet(const Ball& ball, const glm::dvec3& o, const glm::dvec3& d) {
  const glm::dvec3 off = o - ball.centre;
  const double a = glm::dot(d, d), b = glm::dot(off, d);
  const double root = b * b - a * (glm::dot(off, off) - ball.radius * ball.radius);
  const double t = root < 0 ? -1 : (-b - std::sqrt(root)) / a;
  return t > 1e-9 ? std::optional(t) : std::nullopt;
}

std::vector<ExactTexel> exact_map(const CpuScene& scene, const glm::dvec3& centre, uint32_t side) {
  std::vector<ExactTexel> texels;
  const uint32_t factor = kPicturePx / side;
  for (const View& view : cube_views(centre)) {
    const CpuGBuffer g = seen_through(scene, view, {kPicturePx, kPicturePx});
    const glm::dmat3 to_world(world_from_view(view));
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        glm::dvec3 radiance(0);
        double distance = 0, count = 0;
        for (uint32_t i = 0; i < factor * factor; ++i) {
          const size_t pixel =
              size_t{y * factor + i / factor} * kPicturePx + x * factor + i % factor;
          const bool is_there = g.depth[pixel] > 0;
          radiance += is_there ? glm::dvec3(g.source[pixel]) : glm::dvec3(0);
          if (is_there) distance += glm::length(g.position_view[pixel]);
          count += is_there;
        }
        const glm::dvec3 ray((2 * x + 1.0) / side - 1, 1 - (2 * y + 1.0) / side, -1);
        const double l = glm::length(ray);
        texels.push_back({centre, glm::normalize(to_world * ray),
                          radiance / double(factor * factor), count > 0 ? distance / count : kFar,
                          4 / (side * side * l * l * l + 4 / kPi)});
      }
    }
  }
  return texels;
}

}  // namespace lueur
