// SPDX-License-Identifier: MIT
// L. Szirmay-Kalos, I. Lazányi, "Indirect Diffuse and Glossy Illumination on the GPU", 2006 (LCM).
#ifndef LUEUR_CUBE_MAPS_EQUATIONS_H
#define LUEUR_CUBE_MAPS_EQUATIONS_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// LCM 4: the solid angle of a texel, seen from the centre of a cube whose faces have side x side of
// them. `ray_length` is the length of the way to the texel's middle, on the cube of edge 2. In sr.
//   4 / (M^2 |L|^3 + 4 / pi)
// The disc's 4 / pi makes it smaller than it is, all of them together by 11 % of 4 pi for M = 2, by
// 3 % for 4, by 0.8 % for 8.
LUEUR_SHARED float texel_solid_angle(float side, float ray_length) {
  return 4.0f / (side * side * ray_length * ray_length * ray_length + 1.27323954473516f);
}

// A surface seen through a texel, as points near the map's centre see it:
//   solid angle / pi = gain / (r^2 shrink + gain),  r being the way to it.
struct TexelLight {
  vec3 position;
  float gain;  // d^2 dw / pi, m^2: d the distance from the centre, dw the texel's solid angle
  vec3 radiance;
  float shrink;  // 1 - dw / pi
};

// LCM 4, dw* over pi:
//   dw* = d^2 dw / (r^2 (1 - dw / pi) + d^2 dw / pi)
LUEUR_SHARED float localized_share(TexelLight light, float r2) {
  return light.gain / (r2 * light.shrink + light.gain);
}

LUEUR_NAMESPACE_END

#endif
