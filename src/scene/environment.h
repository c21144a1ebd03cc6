// SPDX-License-Identifier: MIT
// Light from far away on all sides, as a picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace lueur {

// Linear Rec.709 radiance in cd/m2 on the whole sphere of directions, in equirectangular
// projection: u goes once around, v from +y down to -y. Unturned, the middle column looks along -z
// and the middle of the right half along +x, as a camera on an unturned node sees it.
struct Environment {
  std::string name;
  uint32_t width = 0;      // pixels
  uint32_t height = 0;     // pixels; half of the width where they are to be square
  std::vector<float> rgb;  // width * height * 3, rows from the top; finite, not negative
  float rotation_rad = 0;  // about +y, counter-clockwise seen from above
  float intensity = 1;     // multiplies
};

// Turns a direction of the world into the picture's own.
glm::mat3 environment_from_world(const Environment& environment);

struct EnvironmentLevel {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<float> rgb;
};
// The picture without its intensity at sides / 2^level, rounded down but not to 0, each pixel the
// mean over its area. Level 0 is the picture itself.
EnvironmentLevel environment_level(const Environment& environment, uint32_t level);
// The next level after `level`.
EnvironmentLevel halved(const EnvironmentLevel& level);
// The last one has one pixel.
uint32_t environment_level_count(const Environment& environment);

// The level at which the eye sees the picture: the coarsest whose pixels are no higher than those
// of a view are on its axis, `pixel_rad` high. One for the whole view, so that neither the seam nor
// the poles show.
uint32_t background_level(const Environment& environment, float pixel_rad);

}  // namespace lueur
