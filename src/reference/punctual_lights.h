// SPDX-License-Identifier: MIT
// Light straight from punctual lights, as the renderer's light pass has it but with exact shadows.
#pragma once

#include "reference/world.h"

namespace lueur::reference {

// Whether there is no light in it at all.
inline bool is_black(const glm::vec3& light) {
  return light == glm::vec3(0.0f);
}

// Light of one light at one point, as if nothing stood between.
struct Arrival {
  glm::vec3 to_light{0.0f};    // unit
  glm::vec3 irradiance{0.0f};  // on a surface that faces it; on others, times the cosine
  float distance_m = 0;        // infinite for directional lights
};
Arrival arrival(const PlacedLight& light, const glm::vec3& position);

// Whether the light of `arrival` reaches the surface. Traces a ray.
bool arrives(const World& world, const Touch& touch, const Arrival& arrival);

// What all lights give a surface that is seen by `bsdf`.
struct DirectLight {
  glm::vec3 irradiance{0.0f};
  glm::vec3 specular{0.0f};  // reflected radiance through the specular lobe
};
DirectLight direct_light(const World& world, const Surface& surface, const Bsdf& bsdf,
                         uint64_t& rays);

// The light of one of them, found by one ray at most: `u` in [0, 1) picks a light in proportion to
// its irradiance, which is divided by that share. Black where it does not arrive.
Arrival one_arrival(const World& world, const Touch& touch, float u, uint64_t& rays);

}  // namespace lueur::reference
