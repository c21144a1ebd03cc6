// SPDX-License-Identifier: MIT
#include "lights/light_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>
#include <numeric>
#include <random>

#include "lights/light_views.h"
#include "shading/halton.h"

namespace lueur {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr uint64_t kMostTries = 1 << 20;

// Points of the unit square, one after the other.
class Points {
 public:
  explicit Points(uint32_t seed) : is_random_(seed != 0), random_(seed) {}
  glm::dvec2 next() {
    if (is_random_) {
      const double x = unit_(random_);
      return {x, unit_(random_)};
    }
    ++i_;  // 0 would be the square's corner
    return halton_2_3(i_);
  }

 private:
  bool is_random_;
  uint32_t i_ = 0;
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

glm::dvec3 as_dvec3(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

// SOL 3.1: phi = 2 pi Phi_2(i), delta = arcsin(2 Phi_3(i) - 1).
glm::dvec3 on_sphere(const glm::dvec2& point) {
  const double phi = 2.0 * kPi * point.x;
  const double sine = 2.0 * point.y - 1.0;
  const double cosine = std::sqrt(std::max(1.0 - sine * sine, 0.0));
  return {std::sin(phi) * cosine, std::cos(phi) * cosine, sine};
}

std::vector<LightRay> rays_in_cone(const glm::vec3& origin, const glm::dvec3& axis,
                                   double cos_angle, uint32_t count, Points points) {
  std::vector<LightRay> rays;
  for (uint64_t i = 0; i < kMostTries && rays.size() < count; ++i) {
    const glm::dvec3 direction = on_sphere(points.next());
    if (glm::dot(direction, axis) >= cos_angle)
      rays.push_back({origin, glm::vec3(direction), 0.0f});
  }
  const double solid_angle_sr = 2.0 * kPi * (1.0 - cos_angle);
  for (LightRay& ray : rays)
    ray.solid_angle_sr = static_cast<float>(solid_angle_sr / static_cast<double>(rays.size()));
  return rays;
}

bool meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& direction) {
  const glm::dvec3 a = (as_dvec3(box.min) - origin) / direction;
  const glm::dvec3 b = (as_dvec3(box.max) - origin) / direction;
  const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
  return std::max({near.x, near.y, near.z}) <= std::min({far.x, far.y, far.z});
}

// Those of the view's that meet the box.
std::vector<LightRay> rays_through(const View& view, const Box& box, uint32_t count,
                                   Points points) {
  const glm::dmat4 world_from_view =
      glm::inverse(glm::dmat4(glm::make_mat4(view.view_from_world.data())));
  const glm::vec3 origin(world_from_view[3]);
  const double half_width = 1.0 / view.clip_from_view[0];
  std::vector<LightRay> rays;
  uint64_t tried = 0;
  for (; tried < kMostTries && rays.size() < count; ++tried) {
    const glm::dvec3 through((2.0 * points.next() - 1.0) * half_width, -1.0);
    const double length = glm::length(through);
    const glm::dvec3 direction = glm::dmat3(world_from_view) * through / length;
    if (!meets(box, glm::dvec3(origin), direction)) continue;
    // What a part of the view's plane is in solid angle, as yet.
    rays.push_back(
        {origin, glm::vec3(direction), static_cast<float>(1.0 / (length * length * length))});
  }
  const double area =
      4.0 * half_width * half_width / static_cast<double>(std::max(tried, uint64_t{1}));
  for (LightRay& ray : rays) ray.solid_angle_sr *= static_cast<float>(area);
  return rays;
}

// Relative to the other lights.
double flux(const PunctualLight& light, const Box& bounds) {
  const glm::dvec3 intensity = as_dvec3(light.intensity);
  const double amount = 0.2126 * intensity.r + 0.7152 * intensity.g + 0.0722 * intensity.b;
  switch (light.kind) {
    case PunctualLight::Kind::point:
      return 4.0 * kPi * amount;
    case PunctualLight::Kind::spot:
      return 2.0 * kPi * (1.0 - std::cos(double{light.outer_cone_rad})) * amount;
    case PunctualLight::Kind::directional: {
      const double diameter_m = glm::length(as_dvec3(bounds.max) - as_dvec3(bounds.min));
      return 0.25 * kPi * diameter_m * diameter_m * amount;
    }
  }
  return 0.0;
}

}  // namespace

std::vector<LightRay> rays_of_light(const PunctualLight& light, const Box& bounds, uint32_t count,
                                    uint32_t seed) {
  if (count == 0) return {};
  const glm::vec3 origin(as_dvec3(light.position));
  switch (light.kind) {
    case PunctualLight::Kind::point:
      return rays_in_cone(origin, {0, 0, 1}, -1.0, count, Points(seed));
    case PunctualLight::Kind::spot:
      return rays_in_cone(origin, as_dvec3(light.direction), std::cos(double{light.outer_cone_rad}),
                          count, Points(seed));
    case PunctualLight::Kind::directional:
      return rays_through(views_of_light(light, bounds).front(), bounds, count, Points(seed));
  }
  return {};
}

std::vector<uint32_t> shares_of_lights(std::span<const PunctualLight> lights, const Box& bounds,
                                       uint32_t count) {
  std::vector<double> fluxes;
  for (const PunctualLight& light : lights) fluxes.push_back(std::max(flux(light, bounds), 0.0));
  double left = std::accumulate(fluxes.begin(), fluxes.end(), 0.0);
  // The dimmest first: what they get more than is theirs is taken from brighter ones.
  std::vector<size_t> order(lights.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return fluxes[a] < fluxes[b]; });
  std::vector<uint32_t> shares(lights.size(), 0);
  for (const size_t i : order) {
    if (fluxes[i] <= 0.0 || count == 0) continue;
    const auto share = static_cast<uint32_t>(std::lround(count * fluxes[i] / left));
    shares[i] = std::min(std::max(share, 1u), count);
    left -= fluxes[i];
    count -= shares[i];
  }
  return shares;
}

std::vector<SeenLightRay> rays_in_view(std::span<const LightRay> rays, const View& view,
                                       uint32_t extent_px, std::vector<bool>& taken) {
  const glm::mat3 view_from_world(glm::make_mat4(view.view_from_world.data()));
  std::vector<SeenLightRay> seen;
  for (uint32_t i = 0; i < rays.size(); ++i) {
    const glm::vec3 d = view_from_world * rays[i].direction;
    if (taken[i] || d.z >= 0.0f) continue;
    const glm::vec2 clip =
        glm::vec2(d.x * view.clip_from_view[0], d.y * view.clip_from_view[5]) / -d.z;
    if (std::max(std::abs(clip.x), std::abs(clip.y)) > 1.0f) continue;
    taken[i] = true;
    const glm::vec2 at_px = (0.5f * clip + 0.5f) * static_cast<float>(extent_px);
    seen.push_back({at_px, rays[i].solid_angle_sr});
  }
  return seen;
}

}  // namespace lueur
