// SPDX-License-Identifier: MIT
// What the camera sees through the centre of each pixel: the reference's own G-buffer.
#pragma once

#include <optional>
#include <vector>

#include "image/image.h"
#include "reference/camera.h"
#include "reference/world.h"

namespace lueur::reference {

struct FirstHit {
  Surface surface;
  glm::vec3 to_eye{0.0f};  // unit
  float z_m = 0;           // along the optical axis
};
std::optional<FirstHit> first_hit(const World& world, const PinholeCamera& camera, uint32_t x,
                                  uint32_t y);

// Writes a pixel of three channels.
void store(ImageF& image, uint32_t x, uint32_t y, const glm::vec3& value);

// Layers of a Rendering that need no random numbers. Black and 0 where nothing is.
struct GBufferLayers {
  ImageF depth, normal, albedo, emission, source, specular;
  GBufferLayers(uint32_t width, uint32_t height);
  // Adds the rays that it traces to `rays`.
  void set(const World& world, const FirstHit& hit, uint32_t x, uint32_t y, uint64_t& rays);
};

}  // namespace lueur::reference
