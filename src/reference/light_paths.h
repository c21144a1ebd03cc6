// SPDX-License-Identifier: MIT
// Monte Carlo estimates of the light that arrives at a point which the camera sees.
#pragma once

#include "reference/camera.h"
#include "reference/emitters.h"
#include "reference/environment_light.h"
#include "reference/first_hits.h"
#include "reference/reference.h"
#include "reference/sampler.h"

namespace lueur::reference {

// A surface as seen from where the path came.
struct PathVertex {
  const Touch& surface;
  Bsdf bsdf;

  // Nothing comes from below the triangle, which is its own inside.
  bool faces(const glm::vec3& to_light) const {
    return glm::dot(surface.geometric_normal, to_light) > 0.0f;
  }
  // f cos, for light from `to_light`.
  glm::vec3 specular(const glm::vec3& to_light) const {
    return bsdf.specular(to_light) * bsdf.cosine(to_light);
  }
  glm::vec3 reflected(const glm::vec3& to_light) const;
};

// One sample's estimates; of `ambient`, diffuse.r is the occlusion.
struct PathSample {
  glm::vec3 diffuse{0.0f};   // E/pi
  glm::vec3 specular{0.0f};  // radiance to the eye
};

// Estimates the integrals of reference.h. Next-event estimation at each point: one ray to a
// punctual light, one to a glowing triangle, one to the environment; the latter two are weighted
// against the directions that the BRDF picks (balance heuristic, Veach 1995). From the fifth
// surface on paths end at random.
class LightPaths {
 public:
  // All must outlive this. `settings.mode` is path, screen or ambient. `environment` is null where
  // there is none; only path knows it.
  LightPaths(const World& world, const Emitters& emitters, const EnvironmentLight* environment,
             const PinholeCamera& camera, const Settings& settings)
      : world_(world),
        emitters_(emitters),
        environment_(settings.mode == Mode::path ? environment : nullptr),
        camera_(camera),
        settings_(settings) {}

  // Where all paths of a pixel begin. `first` must outlive it.
  PathVertex begin(const FirstHit& first) const;
  // Adds the rays that it traces to `rays`.
  PathSample sample(const PathVertex& first, Sampler& sampler, uint64_t& rays) const;

 private:
  PathSample ambient(const PathVertex& first, Sampler& sampler, uint64_t& rays) const;
  glm::vec3 emitter_radiance(const PathVertex& at, glm::vec3& to_light, Sampler& sampler,
                             uint64_t& rays) const;
  glm::vec3 emission_found(const Touch& found, const PathVertex& from,
                           const Bsdf::Sample& direction, uint64_t& rays) const;
  glm::vec3 sky_radiance(const PathVertex& at, glm::vec3& to_light, Sampler& sampler,
                         uint64_t& rays) const;
  glm::vec3 sky_found(const Bsdf::Sample& direction) const;
  float pick_light(Sampler& sampler) const;
  Bsdf sending_bsdf(const Touch& touch, const glm::vec3& to_eye) const;
  bool seen_by_camera(const Touch& surface, uint64_t& rays) const;
  glm::vec3 arriving(const Touch& met, const glm::vec3& to_eye, Sampler& sampler,
                     uint64_t& rays) const;

  const World& world_;
  const Emitters& emitters_;
  const EnvironmentLight* environment_;
  const PinholeCamera& camera_;
  const Settings& settings_;
};

}  // namespace lueur::reference
