// SPDX-License-Identifier: MIT
// glTF 2.0's metallic-roughness material (appendix B of its specification), split into the diffuse
// part, which screen-space techniques pass on, and the specular part, which they do not.
#ifndef LUEUR_SHADING_BRDF_H
#define LUEUR_SHADING_BRDF_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

const float kPi = 3.14159265358979f;

// The smallest alpha that half floats and punctual lights bear: highlights stay finite.
const float kLeastAlpha = 0.002f;

LUEUR_SHARED vec3 diffuse_albedo(vec3 base_color, float metallic) {
  return base_color * (1.0f - metallic);
}

// `specular` is the share of a dielectric's reflectance that is there: KHR_materials_specular.
LUEUR_SHARED vec3 specular_f0(vec3 base_color, float metallic, float specular) {
  return mix(vec3(0.04f * specular), base_color, metallic);
}

// At grazing angles everything mirrors, but for the share that is left out.
LUEUR_SHARED float specular_f90(float metallic, float specular) {
  return mix(specular, 1.0f, metallic);
}

LUEUR_SHARED vec3 fresnel_schlick(vec3 f0, float f90, float cos_half) {
  const float m = 1.0f - cos_half;
  const float m2 = m * m;
  return f0 + (vec3(f90) - f0) * (m2 * m2 * m);
}

// What GBuffer::reflectance says that a surface reflects, seen at this cosine. At grazing angles
// all mirrors, but for what hardly reflects at all: a dielectric's 0.04 counts as whole, and what
// has less of it has its share. A cosine lobe's colour is what it is.
LUEUR_SHARED vec3 reflected_share(vec4 reflectance, float cos_view) {
  const vec3 f0 = vec3(reflectance.x, reflectance.y, reflectance.z);
  if (reflectance.w < 0.0f) return f0;
  const float f90 = clamp(25.0f * max(max(f0.x, f0.y), f0.z), 0.0f, 1.0f);
  return fresnel_schlick(f0, f90, cos_view);
}

// GGX with height-correlated Smith shadowing: brdf, without the cosine. Cosines are positive.
LUEUR_SHARED vec3 ggx_brdf(vec3 f0, float f90, float perceptual_roughness, float cos_light,
                           float cos_view, float cos_normal_half, float cos_light_half) {
  const float alpha = max(perceptual_roughness * perceptual_roughness, kLeastAlpha);
  const float a2 = alpha * alpha;
  const float d = cos_normal_half * cos_normal_half * (a2 - 1.0f) + 1.0f;
  const float distribution = a2 / (kPi * d * d);
  const float visibility = 0.5f / (cos_light * sqrt(cos_view * cos_view * (1.0f - a2) + a2) +
                                   cos_view * sqrt(cos_light * cos_light * (1.0f - a2) + a2));
  return fresnel_schlick(f0, f90, cos_light_half) * (distribution * visibility);
}

LUEUR_NAMESPACE_END

#endif
