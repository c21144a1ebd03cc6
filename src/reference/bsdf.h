// SPDX-License-Identifier: MIT
// What a surface reflects: the renderer's diffuse and GGX lobes, and Phong's and Lafortune's.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "scene/scene.h"

namespace lueur::reference {

// An orthonormal frame around a unit normal.
struct Frame {
  explicit Frame(const glm::vec3& normal);
  glm::vec3 to_world(const glm::vec3& v) const { return v.x * x + v.y * y + v.z * z; }
  glm::vec3 to_local(const glm::vec3& v) const {
    return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)};
  }
  glm::vec3 x, y, z;
};

// A unit vector around +z with density cos / pi.
glm::vec3 cosine_direction(glm::vec2 u);

struct BsdfParameters {
  glm::vec3 normal{0, 0, 1};  // unit, shading normal on the side of `to_eye` or nearly so
  glm::vec3 to_eye{0, 0, 1};  // unit, where the light goes
  glm::vec3 diffuse_albedo{0.0f};
  glm::vec3 specular_f0{0.0f};  // of GGX; unused with `phong`
  float specular_f90 = 0.0f;
  float roughness = 1.0f;  // perceptual
  std::optional<PhongLobe> phong;
};

// The lobes at one point towards one eye. Directions are unit vectors in world space that point
// away from the surface; below the normal's horizon everything is 0.
class Bsdf {
 public:
  // `least_diffuse_share` is the least share of samples that the diffuse lobe gets.
  Bsdf(const BsdfParameters& parameters, float least_diffuse_share);

  glm::vec3 diffuse() const { return parameters_.diffuse_albedo; }  // albedo; f = albedo / pi
  // f_s, without the cosine.
  glm::vec3 specular(const glm::vec3& to_light) const;
  float cosine(const glm::vec3& to_light) const {
    return glm::max(glm::dot(parameters_.normal, to_light), 0.0f);
  }

  // A direction by one lobe or the other, and the density per steradian of all ways to get it.
  struct Sample {
    glm::vec3 to_light{0.0f};
    float pdf = 0;  // 0: no direction; the sample counts, with nothing
  };
  // `u` in [0, 1)²; its first number also picks the lobe.
  Sample sample(glm::vec2 u) const;
  float pdf(const glm::vec3& to_light) const;

 private:
  float specular_pdf(const glm::vec3& local) const;
  glm::vec3 specular_direction(glm::vec2 u) const;

  BsdfParameters parameters_;
  Frame frame_;
  glm::vec3 eye_local_;  // raised above the horizon where a shading normal has turned it below
  glm::vec3 lobe_axis_;  // local, of the Phong lobe
  float alpha_ = 1.0f;
  float diffuse_share_ = 1.0f;
};

}  // namespace lueur::reference
