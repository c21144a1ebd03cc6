// SPDX-License-Identifier: MIT
#include "techniques/baselines/slice_scenes.h"

#include <algorithm>
#include <cmath>

#include "frame/screen_of_view.h"
#include "techniques/baselines/slice.h"

namespace lueur {
namespace {

constexpr double kHalfWidth = 2, kHeight = 2.5;

// Where a ray meets a rectangle around `middle`, whose half sides are `u` and `v`, from its front.
std::optional<CpuHit> rectangle(const glm::dvec3& o, const glm::dvec3& d, const glm::dvec3& middle,
                                const glm::dvec3& u, const glm::dvec3& v, double radiance) {
  const glm::dvec3 n = glm::normalize(glm::cross(u, v));
  const double t = glm::dot(n, middle - o) / glm::dot(n, d);
  const glm::dvec3 off = o + t * d - middle;
  if (glm::dot(n, d) >= 0 || t <= 0 || std::abs(glm::dot(off, u)) > glm::dot(u, u) ||
      std::abs(glm::dot(off, v)) > glm::dot(v, v))
    return std::nullopt;
  return CpuHit{o + t * d, n, glm::dvec3(radiance)};
}

std::optional<CpuHit> sphere(const glm::dvec3& o, const glm::dvec3& d, const glm::dvec3& centre,
                             double radius, double radiance) {
  const double b = glm::dot(d, o - centre), a = glm::dot(d, d);
  const double root = b * b - a * (glm::dot(o - centre, o - centre) - radius * radius);
  if (root <= 0) return std::nullopt;
  const glm::dvec3 p = o + (-b - std::sqrt(root)) / a * d;
  return CpuHit{p, (p - centre) / radius, glm::dvec3(radiance)};
}

std::optional<CpuHit> nearer(const glm::dvec3& o, std::optional<CpuHit> a,
                             std::optional<CpuHit> b) {
  if (!a || !b) return a ? a : b;
  return glm::length(a->position - o) < glm::length(b->position - o) ? a : b;
}

// What a line of the screen meets at `there`: the pixel's plane, within half and double its
// distance.
std::optional<ExactSample> sample_at(const CpuGBuffer& g, const Screen& screen,
                                     const glm::dmat3& view_from_world, vec2 there) {
  if (there.x < 0 || there.y < 0 || there.x >= static_cast<float>(g.extent.width) ||
      there.y >= static_cast<float>(g.extent.height))
    return std::nullopt;
  const size_t q = static_cast<size_t>(there.y) * g.extent.width + static_cast<size_t>(there.x);
  if (g.depth[q] == 0) return std::nullopt;
  const glm::dvec3 n = view_from_world * glm::dvec3(g.normal[q]);
  const glm::dvec3 ray(glm::dvec2(ray_through(screen, there)), -1);
  const double z = -g.position_view[q].z;
  const double on_line =
      glm::dot(n, ray) < 0 ? glm::dot(n, g.position_view[q]) / glm::dot(n, ray) : z;
  return ExactSample{.front = ray * std::clamp(on_line, 0.5 * z, 2 * z),
                     .to = {},
                     .normal = n,
                     .radiance = double{g.source[q].x}};
}

}  // namespace

std::optional<CpuHit> floor_only(const glm::dvec3& o, const glm::dvec3& d) {
  return rectangle(o, d, {0, -1, 0}, {0, 0, 1e4}, {1e4, 0, 0}, 1);
}

std::optional<CpuHit> wall_and_floor(const glm::dvec3& o, const glm::dvec3& d) {
  return nearer(
      o, rectangle(o, d, {0, -1, 0}, {0, 0, -kWallZ}, {1e4, 0, 0}, 0),
      rectangle(o, d, {0, -1 + kHeight / 2, kWallZ}, {kHalfWidth, 0, 0}, {0, kHeight / 2, 0}, 1));
}

// Two rectangles at a right angle to the floor, each with a corner beside the point.
double form_factor_of_wall(const glm::dvec3& floor_point) {
  const double away = floor_point.z - kWallZ, top = std::hypot(away, kHeight);
  double sum = 0;
  for (const double width : {kHalfWidth - floor_point.x, kHalfWidth + floor_point.x})
    sum += (std::atan(width / away) - away / top * std::atan(width / top)) / (2 * kPi);
  return sum;
}

CpuGBuffer see_wall(Extent extent, const CpuScene& scene) {
  return cast_g_buffer(scene, extent, 1.2, {0, 0.5, 0});
}

std::vector<std::optional<glm::dvec3>> floor_places(const CpuGBuffer& g) {
  std::vector<std::optional<glm::dvec3>> places(g.depth.size());
  for (size_t i = 0; i < g.depth.size(); ++i) {
    if (g.depth[i] == 0) continue;
    const glm::dvec3 p(world_from_view(g.view) * glm::dvec4(g.position_view[i], 1));
    if (std::abs(p.y + 1) < 1e-3 && std::abs(p.x) < 1.5) places[i] = p;
  }
  return places;
}

std::optional<CpuHit> balls(const glm::dvec3& o, const glm::dvec3& d) {
  auto hit =
      nearer(o, sphere(o, d, {0.3, -0.3, -3.2}, 0.5, 2), sphere(o, d, {1.2, -0.4, -3}, 0.3, 1));
  hit = nearer(o, hit, rectangle(o, d, {0, -1, 0}, {0, 0, -kWallZ}, {1e4, 0, 0}, 0.25));
  return nearer(o, hit, rectangle(o, d, {0, 0, kWallZ}, {1e4, 0, 0}, {0, 1e4, 0}, 1));
}

double ExactSlice::angle(const glm::dvec3& to) const {
  return std::atan2(glm::dot(to, along), glm::dot(to, to_eye));
}

double ExactSlice::weight_at(double h) const {
  const glm::dvec3 to = std::cos(h) * to_eye + std::sin(h) * along;
  return std::abs(std::sin(h)) * std::max(glm::dot(to, normal), 0.0);
}

std::vector<ExactSlice> exact_slices(const CpuGBuffer& g, size_t pixel, const SliceSettings& s) {
  const Screen screen = screen_of_view(g.view, g.extent);
  const glm::dmat3 view_from_world = glm::transpose(glm::dmat3(world_from_view(g.view)));
  const auto normal = [&](size_t i) { return view_from_world * glm::dvec3(g.normal[i]); };
  const uvec2 at(pixel % g.extent.width, pixel / g.extent.width);
  const vec2 at_px = vec2(at) + 0.5f, extent(g.extent.width, g.extent.height);
  const glm::dvec3 p = g.position_view[pixel];
  const auto slices = static_cast<uint>(s.slices), samples = static_cast<uint>(s.samples);
  std::vector<ExactSlice> all(slices);
  for (uint k = 0; k < slices; ++k) {
    ExactSlice& slice = all[k];
    const vec2 start = slice_start(at, 0, k);
    const vec2 direction = slice_direction(k, slices, start.y);
    const vec2 line = direction * screen.ray_scale;
    const glm::dvec3 step(line, 0);
    slice.normal = normal(pixel);
    slice.to_eye = -glm::normalize(p);
    const glm::dvec3 seen_step = step - slice.to_eye * glm::dot(step, slice.to_eye);
    slice.along = glm::normalize(seen_step);
    // By how much the slice turns around the ray where it turns a little on the screen.
    const glm::dvec3 turned(glm::dvec2(-direction.y, direction.x) * glm::dvec2(screen.ray_scale),
                            0);
    slice.turn =
        std::abs(glm::dot(glm::cross(slice.to_eye, slice.along), turned)) / glm::length(seen_step);
    for (const float side : {1.0f, -1.0f}) {
      const vec2 to_side = side * direction;
      const float reach =
          reach_px(at_px, to_side, extent, s.radius_m, static_cast<float>(-p.z), line);
      bool after_gap = false;
      for (uint i = 0; i < samples; ++i) {
        const vec2 there = at_px + to_side * sample_offset_px(i, samples, start.x, reach);
        std::optional<ExactSample> hit = sample_at(g, screen, view_from_world, there);
        if (hit) hit->to = hit->front - p;
        if (hit && glm::length(hit->to) > double{s.radius_m}) hit.reset();
        if (hit) {
          hit->after_gap = after_gap;
          (side > 0 ? slice.positive : slice.negative).push_back(*hit);
        }
        after_gap = !hit;
      }
    }
  }
  return all;
}

}  // namespace lueur
