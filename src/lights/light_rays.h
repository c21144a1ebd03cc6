// SPDX-License-Identifier: MIT
// Where a light's flux goes, in equal parts: section 3.1 of "Second-Order Illumination in
// Real-Time" (Cochran, Steele 2007).
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lueur/host.h"
#include "lueur/view.h"

namespace lueur {

// One part of a light: all of what it sends into this solid angle around a direction.
struct LightRay {
  glm::vec3 origin;     // world space: the light, or where the view of a directional one stands
  glm::vec3 direction;  // unit
  float solid_angle_sr;
};

// `count` rays that stand for all that a light shines on.
//   point, spot    the sequence's points on the sphere, of which the first in the cone are taken.
//                  They are fixed in the world: a spot that turns keeps those that stay in its cone
//   directional    points of the square that its view sees, from the view's eye, as far as the box
//                  is behind them
// A cone so narrow that few of the first million points are in it gets as many as there are. A
// seed other than 0: random points instead, others for each seed.
std::vector<LightRay> rays_of_light(const PunctualLight& light, const Box& bounds, uint32_t count,
                                    uint32_t seed = 0);

// How many of `count` rays each light gets: in proportion to its flux, at least one where there is
// any, as long as there are enough.
std::vector<uint32_t> shares_of_lights(std::span<const PunctualLight> lights, const Box& bounds,
                                       uint32_t count);

// A ray as one of the light's views sees it.
struct SeenLightRay {
  glm::vec2 at_px;
  float solid_angle_sr;
};

// Those of the rays that this square view sees, `extent_px` wide. Each ray is in one view: those
// taken are marked in `taken`, one entry a ray.
std::vector<SeenLightRay> rays_in_view(std::span<const LightRay> rays, const View& view,
                                       uint32_t extent_px, std::vector<bool>& taken);

}  // namespace lueur
