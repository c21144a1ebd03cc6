// SPDX-License-Identifier: MIT
// What the technique's tests share: rendering from a CPU's G-buffer, and scenes to look at.
#pragma once

#include <vector>

#include "lueur/hierarchical.h"
#include "support/gpu_test.h"

namespace lueur {

class HierarchicalTest : public GpuTest {
 protected:
  using Settings = HierarchicalSettings;
  using Light = std::vector<glm::dvec3>;  // a value a pixel

  // E/pi of every pixel, by a technique that has seen nothing before.
  Light diffuse(const CpuGBuffer& g, const Settings& settings, uint32_t seed = 0);

  // The next frame of a technique with a memory. What `inputs` has of view and G-buffer is filled
  // in from `g`.
  struct Frames {
    Light diffuse, specular;
  };
  Frames next_frame(Hierarchical& technique, const CpuGBuffer& g, Inputs inputs);
};

// Every pixel of one full-resolution level, unfiltered: nothing but equation (4) is left.
HierarchicalSettings exhaustive();

// A room's corner with a sphere in it: floor, back wall and side wall, each with its radiance.
std::optional<CpuHit> corner_room(const glm::dvec3& origin, const glm::dvec3& direction);

// The inside of a sphere, white and black by turns: nothing touches, so that what differs is
// sampling alone.
std::optional<CpuHit> striped_sphere(const glm::dvec3& origin, const glm::dvec3& direction);

// The inside of a sphere of radiance 1, seen from its centre.
std::optional<CpuHit> white_sphere(const glm::dvec3& origin, const glm::dvec3& direction);

double relative_rmse(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& truth);

}  // namespace lueur
