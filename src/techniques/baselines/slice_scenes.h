// SPDX-License-Identifier: MIT
// For tests: scenes with known answers, and the samples of slices again, in double precision.
#pragma once

#include <array>
#include <vector>

#include "support/gpu_test.h"

namespace lueur {

// An endless floor at y = -1.
std::optional<CpuHit> floor_only(const glm::dvec3& origin, const glm::dvec3& direction);

// A black floor at y = -1 that ends at z = -5, where a wall of radiance 1 stands on it: 4 m wide,
// with x = 0 in its middle, and 2.5 m high.
inline constexpr double kWallZ = -5;
std::optional<CpuHit> wall_and_floor(const glm::dvec3& origin, const glm::dvec3& direction);
// The wall's cosine-weighted share of the hemisphere over a point of the floor.
double form_factor_of_wall(const glm::dvec3& floor_point);
// Where the camera sees all of the wall.
CpuGBuffer see_wall(Extent extent, const CpuScene& scene = wall_and_floor);
// The place of each pixel of the floor before the wall but at its sides; nothing for other pixels.
std::vector<std::optional<glm::dvec3>> floor_places(const CpuGBuffer& g);

// A floor and an endless wall, and two balls far before it, each with its radiance.
std::optional<CpuHit> balls(const glm::dvec3& origin, const glm::dvec3& direction);

struct ExactSample {
  glm::dvec3 front;        // view space
  glm::dvec3 to;           // from the receiver
  glm::dvec3 normal;       // view space
  double radiance = 0;     // red
  bool after_gap = false;  // the one before hit nothing, or nothing within the radius
};

// A slice with what its samples hit within the radius, from near to far.
struct ExactSlice {
  glm::dvec3 to_eye, along, normal;
  double turn = 0;  // around the ray, by turn on the screen
  std::vector<ExactSample> positive, negative;

  double angle(const glm::dvec3& to) const;
  // |sin h| |n_p| cos(h - gamma), without the use of either.
  double weight_at(double h) const;
};

struct SliceSettings {
  int32_t slices, samples;
  float radius_m;
};
std::vector<ExactSlice> exact_slices(const CpuGBuffer& g, size_t pixel, const SliceSettings& s);

}  // namespace lueur
