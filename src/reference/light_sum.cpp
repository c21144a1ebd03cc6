// SPDX-License-Identifier: MIT
#include "reference/light_sum.h"

#include <algorithm>

#include "lights/light_rays.h"
#include "reference/punctual_lights.h"
#include "scene/deform.h"
#include "shading/form_factor.h"

namespace lueur::reference {
namespace {

// Of the way to a patch, so that the patch itself is not in the way.
constexpr float kMostOfTheWay = 0.999f;

}  // namespace

LightSum::LightSum(const World& world, const Shot& shot, const Settings& settings)
    : world_(world),
      is_blocked_(settings.mode == Mode::lights),
      is_bounded_(settings.form_factor == FormFactor::disc) {
  const Bounds box = bounds_at(world.scene(), shot.time_s);
  const Box bounds{{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}};
  std::vector<PunctualLight> lights;
  for (const PlacedLight& light : world.punctual_lights()) lights.push_back(as_punctual(light));
  const std::vector<uint32_t> shares = shares_of_lights(lights, bounds, settings.spp);
  for (size_t i = 0; i < lights.size(); ++i) {
    for (const LightRay& ray : rays_of_light(lights[i], bounds, shares[i])) {
      const Ray traced{ray.origin, ray.direction};
      const auto hit = world.rays().nearest(traced);
      if (!hit) continue;
      const Surface surface = world.surface(world.touch(traced, *hit));
      const float distance_m = glm::length(surface.position - ray.origin);
      const float cosine = -glm::dot(surface.normal, ray.direction);
      const Arrival arriving = arrival(world.punctual_lights()[i], surface.position);
      const float facing = glm::dot(surface.normal, arriving.to_light);
      if (facing <= 0.0f) continue;
      const float area = ray.solid_angle_sr * distance_m * distance_m /
                         std::max(cosine, 1.0f / kMostForeshortening);
      patches_.push_back({surface.position, surface.normal * (area / kPi), area / kPi,
                          world.diffuse_albedo_of(surface) * arriving.irradiance * (facing / kPi)});
    }
  }
}

uint32_t LightSum::passes() const {
  return static_cast<uint32_t>((patches_.size() + kSamplesPerPass - 1) / kSamplesPerPass);
}

glm::vec3 LightSum::at(const FirstHit& receiver, uint64_t& rays) const {
  const Surface& surface = receiver.surface;
  glm::vec3 sum(0.0f);
  for (size_t i = pass_; i < patches_.size(); i += passes()) {
    const Patch& patch = patches_[i];
    const glm::vec3 to_patch = patch.position - surface.position;
    const float factor = bounded_form_factor(to_patch, surface.normal, patch.normal_area,
                                             is_bounded_ ? patch.area_over_pi : 0.0f);
    if (factor <= 0.0f) continue;
    if (is_blocked_) {
      if (glm::dot(surface.geometric_normal, to_patch) <= 0.0f) continue;
      ++rays;
      const Ray ray{World::origin(surface, to_patch), to_patch};
      if (world_.rays().is_blocked(ray, kMostOfTheWay)) continue;
    }
    sum += factor * patch.radiance;
  }
  return sum * static_cast<float>(passes());
}

}  // namespace lueur::reference
