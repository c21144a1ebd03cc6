// SPDX-License-Identifier: MIT
#include "reference/light_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/punctual_lights.h"
#include "shading/brdf.h"

namespace lueur::reference {
namespace {

// At the point the camera sees, half of the samples at least go by the cosine: `diffuse` is wanted
// before albedo, so it needs them on dark and metallic surfaces, too.
constexpr float kDiffuseShareAtFirst = 0.5f;
constexpr float kDiffuseShareFurther = 0.1f;
constexpr uint32_t kSurfacesBeforeChance = 4;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

float balance(float pdf, float other) {
  return pdf / (pdf + other);
}

}  // namespace

glm::vec3 PathVertex::reflected(const glm::vec3& to_light) const {
  return (bsdf.diffuse() / kPi + bsdf.specular(to_light)) * bsdf.cosine(to_light);
}

PathVertex LightPaths::begin(const FirstHit& first) const {
  const float diffuse_share = settings_.mode == Mode::path ? kDiffuseShareAtFirst : 1.0f;
  return {first.surface, world_.bsdf(first.surface, first.to_eye, diffuse_share)};
}

// A random number only where there is something to choose.
float LightPaths::pick_light(Sampler& sampler) const {
  return world_.punctual_lights().size() > 1 ? sampler.next() : 0.0f;
}

bool LightPaths::seen_by_camera(const Touch& surface, uint64_t& rays) const {
  const glm::vec3 to_eye = camera_.eye() - surface.position;
  if (glm::dot(to_eye, surface.geometric_normal) <= 0.0f || !world_.shows_to_camera(surface) ||
      !camera_.in_view(surface.position))
    return false;
  ++rays;
  // From the camera, as a ray that comes back would take fronts for backs; and from the near plane,
  // before which the camera sees nothing.
  const glm::vec3 way = World::origin(surface, to_eye) - camera_.eye();
  const float near = camera_.near_m() / glm::dot(way, camera_.axis());
  return !world_.rays().is_blocked_for_camera({camera_.eye() + near * way, way}, 1.0f - near);
}

// Radiance from one point of a glowing triangle, over the density per steradian of finding it and
// weighted against the BRDF's sampling.
glm::vec3 LightPaths::emitter_radiance(const PathVertex& at, glm::vec3& to_light, Sampler& sampler,
                                       uint64_t& rays) const {
  const float choice = sampler.next();
  const Emitters::Sample light = emitters_.sample(choice, sampler.next_2d());
  const glm::vec3 way = light.position - at.surface.position;
  const float distance2 = glm::dot(way, way);
  if (!(distance2 > 0.0f) || is_black(light.radiance)) return glm::vec3(0.0f);
  to_light = way / std::sqrt(distance2);
  const float cos_emitter = std::abs(glm::dot(light.normal, to_light));
  if (!at.faces(to_light) || at.bsdf.cosine(to_light) <= 0.0f || cos_emitter <= 0.0f)
    return glm::vec3(0.0f);

  // Both ends are moved off their surfaces, towards each other.
  Touch end;
  end.position = light.position;
  end.geometric_normal = light.normal;
  const glm::vec3 from = World::origin(at.surface, to_light);
  const glm::vec3 to = World::origin(end, -to_light);
  ++rays;
  if (world_.rays().is_blocked({from, to - from}, 1.0f)) return glm::vec3(0.0f);
  if (settings_.mode == Mode::screen) {
    end.part = light.part;
    end.is_front = glm::dot(light.normal, to_light) < 0.0f;
    end.geometric_normal = end.is_front ? light.normal : -light.normal;
    if (!seen_by_camera(end, rays)) return glm::vec3(0.0f);
  }
  const float pdf = light.pdf_area * distance2 / cos_emitter;
  return light.radiance / pdf * balance(pdf, at.bsdf.pdf(to_light));
}

// The emission of what a sampled direction met, weighted against emitter_radiance().
glm::vec3 LightPaths::emission_found(const Touch& found, const PathVertex& from,
                                     const Bsdf::Sample& direction, uint64_t& rays) const {
  const glm::vec3 emission = world_.emission_at(found.part, found.triangle, found.u, found.v);
  if (is_black(emission)) return emission;
  if (settings_.mode == Mode::screen && !seen_by_camera(found, rays)) return glm::vec3(0.0f);
  const float density = emitters_.pdf_area(found.part);
  if (!(density > 0.0f)) return emission;
  const glm::vec3 way = found.position - from.surface.position;
  const float cos_emitter = std::abs(glm::dot(found.geometric_normal, direction.to_light));
  const float pdf = cos_emitter > 0.0f ? density * glm::dot(way, way) / cos_emitter : kInfinity;
  return std::isfinite(pdf) ? emission * balance(direction.pdf, pdf) : glm::vec3(0.0f);
}

// Radiance from one direction of the environment, over the density of finding it and weighted
// against the BRDF's sampling.
glm::vec3 LightPaths::sky_radiance(const PathVertex& at, glm::vec3& to_light, Sampler& sampler,
                                   uint64_t& rays) const {
  const glm::vec2 choice = sampler.next_2d();
  const EnvironmentLight::Sample light = environment_->sample(choice, sampler.next_2d());
  to_light = light.to_light;
  if (!(light.pdf > 0.0f) || !at.faces(to_light) || at.bsdf.cosine(to_light) <= 0.0f)
    return glm::vec3(0.0f);
  ++rays;
  if (world_.rays().is_blocked({World::origin(at.surface, to_light), to_light}, kInfinity))
    return glm::vec3(0.0f);
  return light.radiance / light.pdf * balance(light.pdf, at.bsdf.pdf(to_light));
}

// What a sampled direction that met no surface sees, weighted against sky_radiance().
glm::vec3 LightPaths::sky_found(const Bsdf::Sample& direction) const {
  if (!environment_) return glm::vec3(0.0f);
  return environment_->radiance(direction.to_light) *
         balance(direction.pdf, environment_->pdf(direction.to_light));
}

// What a surface on the way sends on. A G-buffer holds the diffuse part: one value for all
// directions.
Bsdf LightPaths::sending_bsdf(const Touch& touch, const glm::vec3& to_eye) const {
  const Surface surface = world_.surface(touch);
  if (settings_.mode == Mode::path) return world_.bsdf(surface, to_eye, kDiffuseShareFurther);
  return {{.normal = surface.normal,
           .to_eye = to_eye,
           .diffuse_albedo = world_.diffuse_albedo_of(surface)},
          1.0f};
}

// The radiance that leaves `met` towards `to_eye`, its emission left out: one path's estimate.
glm::vec3 LightPaths::arriving(const Touch& met, const glm::vec3& to_eye, Sampler& sampler,
                               uint64_t& rays) const {
  glm::vec3 radiance(0.0f), throughput(1.0f);
  Touch touch = met;
  glm::vec3 eye = to_eye;
  for (uint32_t depth = 1;; ++depth) {
    const Arrival light = one_arrival(world_, touch, pick_light(sampler), rays);
    const bool is_last = depth >= settings_.bounces;
    if (is_last && is_black(light.irradiance)) return radiance;
    if (settings_.mode == Mode::screen && !seen_by_camera(touch, rays)) return radiance;
    const PathVertex vertex{touch, sending_bsdf(touch, eye)};
    if (!is_black(light.irradiance))
      radiance += throughput * light.irradiance * vertex.reflected(light.to_light);
    if (is_last) return radiance;

    if (!emitters_.empty()) {
      glm::vec3 to_light(0.0f);
      const glm::vec3 glow = emitter_radiance(vertex, to_light, sampler, rays);
      if (!is_black(glow)) radiance += throughput * vertex.reflected(to_light) * glow;
    }
    if (environment_) {
      glm::vec3 to_light(0.0f);
      const glm::vec3 sky = sky_radiance(vertex, to_light, sampler, rays);
      if (!is_black(sky)) radiance += throughput * vertex.reflected(to_light) * sky;
    }
    const Bsdf::Sample next = vertex.bsdf.sample(sampler.next_2d());
    if (!(next.pdf > 0.0f) || !vertex.faces(next.to_light)) return radiance;
    throughput *= vertex.reflected(next.to_light) / next.pdf;
    if (depth >= kSurfacesBeforeChance) {
      const float survival = std::min(std::max({throughput.r, throughput.g, throughput.b}), 0.98f);
      if (!(sampler.next() < survival)) return radiance;
      throughput /= survival;
    }
    const Ray ray{World::origin(touch, next.to_light), next.to_light};
    ++rays;
    const std::optional<Hit> hit = world_.rays().nearest(ray);
    if (!hit) return radiance + throughput * sky_found(next);
    const Touch found = world_.touch(ray, *hit);
    radiance += throughput * emission_found(found, vertex, next, rays);
    touch = found;
    eye = -next.to_light;
  }
}

PathSample LightPaths::ambient(const PathVertex& first, Sampler& sampler, uint64_t& rays) const {
  const Bsdf::Sample free = first.bsdf.sample(sampler.next_2d());
  if (!(free.pdf > 0.0f) || !first.faces(free.to_light)) return {};
  ++rays;
  const Ray ray{World::origin(first.surface, free.to_light), free.to_light};
  const bool blocked = world_.rays().is_blocked(ray, settings_.ambient_distance_m);
  return {glm::vec3(blocked ? 0.0f : 1.0f), glm::vec3(0.0f)};
}

PathSample LightPaths::sample(const PathVertex& first, Sampler& sampler, uint64_t& rays) const {
  if (settings_.mode == Mode::ambient) return ambient(first, sampler, rays);
  PathSample sum;
  const auto add = [&](const glm::vec3& to_light, const glm::vec3& radiance) {
    sum.diffuse += radiance * (first.bsdf.cosine(to_light) / kPi);
    if (settings_.mode == Mode::path) sum.specular += radiance * first.specular(to_light);
  };
  if (!emitters_.empty()) {
    glm::vec3 to_light(0.0f);
    const glm::vec3 glow = emitter_radiance(first, to_light, sampler, rays);
    if (!is_black(glow)) add(to_light, glow);
  }
  if (environment_) {
    glm::vec3 to_light(0.0f);
    const glm::vec3 sky = sky_radiance(first, to_light, sampler, rays);
    if (!is_black(sky)) add(to_light, sky);
  }
  const Bsdf::Sample next = first.bsdf.sample(sampler.next_2d());
  if (!(next.pdf > 0.0f) || !first.faces(next.to_light)) return sum;
  const Ray ray{World::origin(first.surface, next.to_light), next.to_light};
  ++rays;
  const std::optional<Hit> hit = world_.rays().nearest(ray);
  if (!hit) {
    const glm::vec3 sky = sky_found(next);
    if (!is_black(sky)) add(next.to_light, sky / next.pdf);
    return sum;
  }
  const Touch met = world_.touch(ray, *hit);
  const glm::vec3 radiance =
      emission_found(met, first, next, rays) + arriving(met, -next.to_light, sampler, rays);
  if (!is_black(radiance)) add(next.to_light, radiance / next.pdf);
  return sum;
}

}  // namespace lueur::reference
