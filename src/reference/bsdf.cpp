// SPDX-License-Identifier: MIT
#include "reference/bsdf.h"

#include <algorithm>
#include <cmath>

#include "image/exposure.h"
#include "shading/brdf.h"

namespace lueur::reference {
namespace {

constexpr float kBelowOne = 0x1.fffffep-1f;
constexpr float kWideAlpha = 0.5f;
constexpr float kLeastCosView = 1e-3f;  // as in the renderer's light pass

float luminance_of(const glm::vec3& c) {
  return lueur::luminance(c.r, c.g, c.b);
}

// The share of the masked microfacets that the eye sees: Smith's G1 of GGX.
float smith_g1(float cos_angle, float alpha) {
  const float c2 = cos_angle * cos_angle;
  return 2.0f * cos_angle / (cos_angle + std::sqrt(alpha * alpha * (1.0f - c2) + c2));
}

float ggx_distribution(float cos_half, float alpha) {
  const float a2 = alpha * alpha;
  const float d = cos_half * cos_half * (a2 - 1.0f) + 1.0f;
  return a2 / (kPi * d * d);
}

// A microfacet normal among those that the eye sees: E. Heitz, "Sampling the GGX Distribution of
// Visible Normals", JCGT 7(4), 2018.
glm::vec3 visible_normal(const glm::vec3& eye, float alpha, glm::vec2 u) {
  const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * eye.x, alpha * eye.y, eye.z));
  const float across = stretched.x * stretched.x + stretched.y * stretched.y;
  const glm::vec3 t1 = across > 0.0f
                           ? glm::vec3(-stretched.y, stretched.x, 0.0f) / std::sqrt(across)
                           : glm::vec3(1, 0, 0);
  const glm::vec3 t2 = glm::cross(stretched, t1);
  const float r = std::sqrt(u.x);
  const float phi = 2.0f * kPi * u.y;
  const float p1 = r * std::cos(phi);
  const float blend = 0.5f * (1.0f + stretched.z);
  const float p2 =
      (1.0f - blend) * std::sqrt(std::max(1.0f - p1 * p1, 0.0f)) + blend * r * std::sin(phi);
  const glm::vec3 n =
      p1 * t1 + p2 * t2 + std::sqrt(std::max(1.0f - p1 * p1 - p2 * p2, 0.0f)) * stretched;
  return glm::normalize(glm::vec3(alpha * n.x, alpha * n.y, std::max(n.z, 1e-6f)));
}

}  // namespace

Frame::Frame(const glm::vec3& normal) : z(normal) {
  // Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
  const float sign = std::copysign(1.0f, z.z);
  const float a = -1.0f / (sign + z.z);
  const float b = z.x * z.y * a;
  x = {1.0f + sign * z.x * z.x * a, sign * b, -sign * z.x};
  y = {b, sign + z.y * z.y * a, -z.y};
}

glm::vec3 cosine_direction(glm::vec2 u) {
  const float r = std::sqrt(u.x);
  const float phi = 2.0f * kPi * u.y;
  return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1.0f - u.x, 0.0f))};
}

Bsdf::Bsdf(const BsdfParameters& parameters, float least_diffuse_share)
    : parameters_(parameters), frame_(parameters.normal) {
  eye_local_ = frame_.to_local(parameters_.to_eye);
  eye_local_.z = std::max(eye_local_.z, kLeastCosView);
  eye_local_ = glm::normalize(eye_local_);
  alpha_ = std::max(parameters_.roughness * parameters_.roughness, kLeastAlpha);

  // Share the samples out by what each lobe about reflects.
  float specular_albedo = 0.0f;
  if (parameters_.phong) {
    const PhongLobe& lobe = *parameters_.phong;
    lobe_axis_ = {lobe.c_xy * eye_local_.x, lobe.c_xy * eye_local_.y, lobe.c_z * eye_local_.z};
    const float length = glm::length(lobe_axis_);
    lobe_axis_ = length > 0.0f ? lobe_axis_ / length : glm::vec3(0, 0, 1);
    specular_albedo = luminance_of(lobe.color);
  } else {
    specular_albedo = luminance_of(
        fresnel_schlick(parameters_.specular_f0, parameters_.specular_f90, eye_local_.z));
  }
  const float diffuse_albedo = luminance_of(parameters_.diffuse_albedo);
  // A wide lobe is as well found by the cosine, which is quicker.
  const bool is_wide = !parameters_.phong && alpha_ > kWideAlpha;
  if (specular_albedo > 0.0f && !is_wide)
    diffuse_share_ =
        std::max(diffuse_albedo / (diffuse_albedo + specular_albedo), least_diffuse_share);
}

glm::vec3 Bsdf::specular(const glm::vec3& to_light) const {
  const float cos_light = glm::dot(parameters_.normal, to_light);
  if (cos_light <= 0.0f) return glm::vec3(0.0f);
  if (parameters_.phong) {
    const PhongLobe& lobe = *parameters_.phong;
    const glm::vec3 local = frame_.to_local(to_light);
    const float most = std::max(std::abs(lobe.c_xy), std::abs(lobe.c_z));
    const float c = lobe.c_xy * (local.x * eye_local_.x + local.y * eye_local_.y) +
                    lobe.c_z * local.z * eye_local_.z;
    if (!(c > 0.0f) || !(most > 0.0f)) return glm::vec3(0.0f);
    return lobe.color * ((lobe.exponent + 2.0f) / (2.0f * kPi)) * std::pow(c / most, lobe.exponent);
  }
  const glm::vec3 half_way = glm::normalize(to_light + parameters_.to_eye);
  return ggx_brdf(parameters_.specular_f0, parameters_.specular_f90, parameters_.roughness,
                  cos_light,
                  std::max(glm::dot(parameters_.normal, parameters_.to_eye), kLeastCosView),
                  std::clamp(glm::dot(parameters_.normal, half_way), 0.0f, 1.0f),
                  std::clamp(glm::dot(to_light, half_way), 0.0f, 1.0f));
}

Bsdf::Sample Bsdf::sample(glm::vec2 u) const {
  // What is left of the number that chose is uniform again.
  const bool is_diffuse = u.x < diffuse_share_;
  u.x = is_diffuse ? u.x / diffuse_share_ : (u.x - diffuse_share_) / (1.0f - diffuse_share_);
  u.x = std::min(u.x, kBelowOne);
  const glm::vec3 local = is_diffuse ? cosine_direction(u) : specular_direction(u);
  if (local.z <= 0.0f) return {};
  const glm::vec3 to_light = frame_.to_world(local);
  return {to_light, pdf(to_light)};
}

float Bsdf::pdf(const glm::vec3& to_light) const {
  const glm::vec3 local = frame_.to_local(to_light);
  if (local.z <= 0.0f) return 0.0f;
  float density = diffuse_share_ * local.z / kPi;
  if (diffuse_share_ < 1.0f) density += (1.0f - diffuse_share_) * specular_pdf(local);
  return density;
}

float Bsdf::specular_pdf(const glm::vec3& local) const {
  if (parameters_.phong) {
    const float n = parameters_.phong->exponent;
    const float c = std::max(glm::dot(local, lobe_axis_), 0.0f);
    return (n + 1.0f) / (2.0f * kPi) * std::pow(c, n);
  }
  const glm::vec3 half_way = glm::normalize(local + eye_local_);
  return smith_g1(eye_local_.z, alpha_) * ggx_distribution(half_way.z, alpha_) /
         (4.0f * eye_local_.z);
}

glm::vec3 Bsdf::specular_direction(glm::vec2 u) const {
  if (parameters_.phong) {
    const float c = std::pow(u.x, 1.0f / (parameters_.phong->exponent + 1.0f));
    const float s = std::sqrt(std::max(1.0f - c * c, 0.0f));
    const float phi = 2.0f * kPi * u.y;
    return Frame(lobe_axis_).to_world({s * std::cos(phi), s * std::sin(phi), c});
  }
  const glm::vec3 normal = visible_normal(eye_local_, alpha_, u);
  return 2.0f * glm::dot(normal, eye_local_) * normal - eye_local_;
}

}  // namespace lueur::reference
