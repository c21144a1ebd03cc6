// SPDX-License-Identifier: MIT
#include "reference/first_hits.h"

#include "reference/punctual_lights.h"
#include "shading/brdf.h"

namespace lueur::reference {

void store(ImageF& image, uint32_t x, uint32_t y, const glm::vec3& value) {
  for (uint32_t c = 0; c < 3; ++c) image.at(x, y, c) = value[static_cast<int>(c)];
}

std::optional<FirstHit> first_hit(const World& world, const PinholeCamera& camera, uint32_t x,
                                  uint32_t y) {
  const Ray ray = camera.ray_through({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
  const std::optional<Hit> hit = world.rays().nearest_for_camera(ray);
  if (!hit) return std::nullopt;
  // The rays of neighbouring pixels start elsewhere on the near plane; seen from the eye all of
  // them start at one point.
  const Ray from_eye{camera.eye(), ray.direction};
  Hit at_eye = *hit;
  at_eye.distance += camera.near_m();
  return FirstHit{world.surface(from_eye, at_eye, camera.step_x(), camera.step_y()),
                  -glm::normalize(ray.direction), at_eye.distance};
}

GBufferLayers::GBufferLayers(uint32_t width, uint32_t height)
    : depth(width, height, 1),
      normal(width, height, 3),
      albedo(width, height, 3),
      emission(width, height, 3),
      source(width, height, 3),
      specular(width, height, 3) {}

void GBufferLayers::set(const World& world, const FirstHit& hit, uint32_t x, uint32_t y,
                        uint64_t& rays) {
  const Surface& s = hit.surface;
  const DirectLight light = direct_light(world, s, world.bsdf(s, hit.to_eye, 0.0f), rays);
  const glm::vec3 diffuse = world.diffuse_albedo_of(s);
  const glm::vec3 glow = world.emission_of(s);
  depth.at(x, y, 0) = hit.z_m;
  store(normal, x, y, s.normal);
  store(albedo, x, y, diffuse);
  store(emission, x, y, glow);
  store(source, x, y, glow + diffuse * light.irradiance / kPi);
  store(specular, x, y, light.specular);
}

}  // namespace lueur::reference
