// SPDX-License-Identifier: MIT
#include "reference/punctual_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/exposure.h"
#include "shading/punctual_light.h"

namespace lueur::reference {

Arrival arrival(const PlacedLight& light, const glm::vec3& position) {
  Arrival a{-light.direction_world, light.intensity, std::numeric_limits<float>::infinity()};
  if (light.kind != LightKind::directional) {
    a.to_light = light.position_world - position;
    a.distance_m = std::max(glm::length(a.to_light), kLeastLightDistance);
    a.to_light /= a.distance_m;
    a.irradiance *= range_window(a.distance_m, light.inverse_range) / (a.distance_m * a.distance_m);
  }
  if (light.kind == LightKind::spot)
    a.irradiance *= cone_attenuation(glm::dot(-a.to_light, light.direction_world), light.cone_scale,
                                     light.cone_offset);
  return a;
}

bool arrives(const World& world, const Touch& touch, const Arrival& a) {
  // Behind the triangle itself, whatever its shading normal says.
  if (glm::dot(touch.geometric_normal, a.to_light) <= 0.0f) return false;
  return !world.rays().is_blocked({World::origin(touch, a.to_light), a.to_light}, a.distance_m);
}

DirectLight direct_light(const World& world, const Surface& surface, const Bsdf& bsdf,
                         uint64_t& rays) {
  DirectLight sum;
  for (const PlacedLight& light : world.punctual_lights()) {
    const Arrival a = arrival(light, surface.position);
    const glm::vec3 irradiance = a.irradiance * bsdf.cosine(a.to_light);
    if (is_black(irradiance)) continue;
    ++rays;
    if (!arrives(world, surface, a)) continue;
    sum.irradiance += irradiance;
    sum.specular += irradiance * bsdf.specular(a.to_light);
  }
  return sum;
}

Arrival one_arrival(const World& world, const Touch& touch, float u, uint64_t& rays) {
  // Lights behind the triangle cannot arrive and are not picked.
  const auto weight_of = [&](const Arrival& a) {
    return glm::dot(touch.geometric_normal, a.to_light) > 0.0f
               ? luminance(a.irradiance.r, a.irradiance.g, a.irradiance.b)
               : 0.0f;
  };
  const std::vector<PlacedLight>& lights = world.punctual_lights();
  float total = 0.0f;
  if (lights.size() > 1)
    for (const PlacedLight& light : lights) total += weight_of(arrival(light, touch.position));
  float left = u * total;
  Arrival chosen;
  float chosen_weight = 0.0f;
  for (const PlacedLight& light : lights) {
    const Arrival a = arrival(light, touch.position);
    const float weight = weight_of(a);
    if (!(weight > 0.0f)) continue;
    // The last light with any weight takes what rounding leaves over.
    chosen = a;
    chosen_weight = weight;
    left -= weight;
    if (left < 0.0f) break;
  }
  if (!(chosen_weight > 0.0f)) return {};
  ++rays;
  if (!arrives(world, touch, chosen)) return {};
  if (lights.size() > 1) chosen.irradiance *= total / chosen_weight;
  return chosen;
}

}  // namespace lueur::reference
