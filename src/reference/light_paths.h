// SPDX-License-Identifier: MIT
// Monte Carlo estimates of the light that arrives at a point which the camera sees.
#pragma once

#include "reference/camera.h"
#include "reference/emitters.h"
#include "reference/first_hits.h"
#include "reference/reference.h"
#include "reference/sampler.h"

namespace lueur::reference {

// One sample's estimates; of `ambient`, diffuse.r is the occlusion.
struct PathSample {
  glm::vec3 diffuse{0.0f};   // E/pi
  glm::vec3 specular{0.0f};  // radiance to the eye
};

// Estimates the integrals of reference.h. Next-event estimation at each point: one ray to a
// punctual light, one to a glowing triangle; the latter is weighted against the directions that the
// BRDF picks (balance heuristic, Veach 1995). From the fifth surface on paths end at random.
class LightPaths {
 public:
  // All must outlive this. `settings.mode` is path, screen or ambient.
  LightPaths(const World& world, const Emitters& emitters, const PinholeCamera& camera,
             const Settings& settings)
      : world_(world), emitters_(emitters), camera_(camera), settings_(settings) {}

  // Adds the rays that it traces to `rays`.
  PathSample sample(const FirstHit& first, Sampler& sampler, uint64_t& rays) const;

 private:
  struct Vertex;
  PathSample ambient(const FirstHit& first, Sampler& sampler, uint64_t& rays) const;
  glm::vec3 emitter_radiance(const Vertex& at, glm::vec3& to_light, Sampler& sampler,
                             uint64_t& rays) const;
  glm::vec3 emission_found(const Surface& found, const Vertex& from, const Bsdf::Sample& direction,
                           uint64_t& rays) const;
  float pick_light(Sampler& sampler) const;
  bool seen_by_camera(const Surface& surface, uint64_t& rays) const;
  glm::vec3 arriving(const Surface& met, const glm::vec3& to_eye, Sampler& sampler,
                     uint64_t& rays) const;

  const World& world_;
  const Emitters& emitters_;
  const PinholeCamera& camera_;
  const Settings& settings_;
};

}  // namespace lueur::reference
