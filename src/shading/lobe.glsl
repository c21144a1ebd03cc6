// SPDX-License-Identifier: MIT
// The glossy lobe of a surface without its colour: GGX by roughness, or a cosine lobe of a table.
// The including shader binds `lobes`, a buffer of CosineLobeData.
#include "shading/brdf.h"
#include "shading/cosine_lobe.h"

struct Lobe {
  bool is_ggx;
  float alpha;     // of GGX
  float exponent;  // of the cosine lobe; of GGX, that of the Phong lobe of its width
  float c_xy;
  float c_z;
};

// A GGX lobe as wide as a cosine lobe: alpha^2 = 2 / (exponent + 2).
float exponent_of_alpha(float alpha) { return max(2.0 / (alpha * alpha) - 2.0, 1.0); }
float alpha_of_exponent(float exponent) { return sqrt(2.0 / (exponent + 2.0)); }

// `code` is a GGX lobe's perceptual roughness, or 2 + i for lobe i of the table.
// What reflects light from everywhere evenly has no lobe to speak of: it counts as a wide one.
Lobe lobe_of(float code) {
  if (code > 1.5) {
    const CosineLobeData c = lobes.data[uint(code - 1.5)];
    return Lobe(false, 0.0, max(c.exponent, 1.0), c.c_xy, c.c_z);
  }
  const float alpha = max(code * code, kLeastAlpha);
  return Lobe(true, alpha, exponent_of_alpha(alpha), -1.0, 1.0);
}

// brdf for a colour, or Fresnel reflectance, of 1; without the cosine. `solid_angle_sr` is that of
// what is looked at: a lobe narrower than it would be hit or missed by chance, so it is widened.
// differs: FDP says nothing of it. To the lobe's variance comes the patch's, twice, as samples do
// not lie evenly.
float lobe_brdf(Lobe lobe, vec3 n, vec3 to_light, vec3 to_eye, float solid_angle_sr) {
  const float cos_light = dot(n, to_light);
  const float cos_view = max(dot(n, to_eye), 1.0e-3);
  if (cos_light <= 0.0) return 0.0;
  const float widening = solid_angle_sr / kPi;
  if (lobe.is_ggx) {
    const float alpha = sqrt(min(lobe.alpha * lobe.alpha + 0.25 * widening, 1.0));
    const vec3 half_way = normalize(to_light + to_eye);
    return ggx_brdf(vec3(1.0), 1.0, sqrt(alpha), cos_light, cos_view,
                    clamp(dot(n, half_way), 0.0, 1.0), 1.0).r;
  }
  const float exponent = 1.0 / (1.0 / lobe.exponent + 0.5 * widening);
  return cosine_lobe(exponent, lobe.c_xy, lobe.c_z, n, to_light, to_eye);
}
