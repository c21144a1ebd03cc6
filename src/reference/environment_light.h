// SPDX-License-Identifier: MIT
// An environment as a light to take samples of, and as what the camera sees behind everything.
#pragma once

#include <vector>

#include "scene/environment.h"
#include "scene/scene.h"

namespace lueur::reference {

// For light each pixel of the picture has one radiance, so that directions are found in exact
// proportion to it. `environment` must outlive this.
class EnvironmentLight {
 public:
  explicit EnvironmentLight(const Environment& environment);
  // Whether it is black all over: then there is nothing to sample.
  bool empty() const { return !(total_ > 0.0); }

  struct Sample {
    glm::vec3 to_light{0.0f};  // unit
    glm::vec3 radiance{0.0f};
    float pdf = 0;  // per steradian
  };
  // A pixel in proportion to luminance times solid angle, by `choice`, and a direction evenly
  // within it. Not when empty().
  Sample sample(const glm::vec2& choice, const glm::vec2& u) const;
  glm::vec3 radiance(const glm::vec3& direction) const;
  // The density per steradian with which sample() finds this direction.
  float pdf(const glm::vec3& direction) const;

 private:
  size_t pixel_of(const glm::vec3& direction) const;
  glm::vec3 radiance_at(size_t pixel) const;
  float pdf_at(size_t pixel) const;

  const Environment* environment_;
  glm::mat3 environment_from_world_;
  double total_ = 0.0;         // luminance over the sphere
  std::vector<float> rows_;    // cumulative share of the total, by row
  std::vector<float> pixels_;  // cumulative share of the row's
};

// What the renderer shows behind everything: one level of the picture, interpolated.
class Backdrop {
 public:
  Backdrop(const Environment& environment, const Camera& camera, uint32_t height_px);
  glm::vec3 at(const glm::vec3& direction) const;

 private:
  glm::vec3 pixel(int64_t x, int64_t y) const;

  EnvironmentLevel level_;
  glm::mat3 environment_from_world_;
  float intensity_;
};

}  // namespace lueur::reference
