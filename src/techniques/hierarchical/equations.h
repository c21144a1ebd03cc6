// SPDX-License-Identifier: MIT
// The papers' formulas that are the technique's own; form factors are in shading/form_factor.h.
#ifndef LUEUR_HIERARCHICAL_EQUATIONS_H
#define LUEUR_HIERARCHICAL_EQUATIONS_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// Where level k gathers, in pixels of level k. Level 0 takes the full disc of radius r, each other
// level the ring r/2 .. r (HSSIL 3.2, radii as in FDP 4). In pixels of level 0 the ring of level k
// reaches from 2^(k-1) r to 2^k r, so it begins where level k-1 ends: no gap, no overlap.
LUEUR_SHARED float ring_inner_px(uint level, float radius_px) {
  return level == 0u ? 0.0f : 0.5f * radius_px;
}

LUEUR_SHARED float ring_area_px(uint level, float radius_px) {
  const float inner = ring_inner_px(level, radius_px);
  return 3.14159265358979f * (radius_px * radius_px - inner * inner);
}

// Samples lie on a spiral with the golden angle between neighbours and equal areas between their
// radii: sample i of n at radius² = inner² + (i + shift) * step, step = (outer² - inner²) / n,
// shift in [0, 1).
const float kGoldenAngle = 2.39996322972865f;

LUEUR_SHARED float sample_step_px2(float inner_px, float outer_px, uint n) {
  return (outer_px * outer_px - inner_px * inner_px) / float(n);
}

LUEUR_SHARED float sample_radius_px(float inner_px, float step_px2, float i_plus_shift) {
  return sqrt(inner_px * inner_px + i_plus_shift * step_px2);
}

// Pixels differ in where their spiral starts, with a period of 3 x 3: nine pixels together hold
// nine interleaved spirals (a rank-1 lattice in shift and turn), and the 3 x 3 filter that follows
// averages just these nine. x: shift in [0, 1), y: turn in [0, 1).
LUEUR_SHARED vec2 spiral_start(uvec2 pixel, uint level, uint seed, bool rotate) {
  const float cell = rotate ? float((pixel.x % 3u) + 3u * (pixel.y % 3u)) : 4.0f;
  const float offset = float(level) * 0.7548776662f + float(seed % 65536u) * 0.6180339887f;
  return fract(vec2((cell + 0.5f) / 9.0f + offset, (cell * 4.0f + 0.5f) / 9.0f + offset * 0.3247f));
}

// FDP 4, "temporal filtering": the largest share of the last frame, less where the picture moves
// fast and where lobes are narrow, as what a surface shows through a narrow lobe does not move with
// it. `exponent` is the cosine lobe's, 1 for diffuse surfaces; a lobe is about 1 / sqrt(exponent)
// wide.
LUEUR_SHARED float history_weight(float most, float moved_px, float exponent) {
  return most * exp(-moved_px * sqrt(exponent) / 200.0f);
}

// FDP (5): what neighbour j adds to the score of pixel i. The widths of the three Gaussians are not
// in the paper: one pixel, a cosine of 0.9, and 2 % of the depth.
LUEUR_SHARED float vote(float distance_px, float cos_normals, float z_difference, float z) {
  const float normals = (1.0f - cos_normals) / 0.1f;
  const float depths = z_difference / (0.02f * z);
  return exp(-0.5f * (distance_px * distance_px + normals * normals + depths * depths));
}

// How much two points belong to the same smooth piece of surface, for the joint bilateral filters.
// The distance of q from p's tangent plane counts against p's depth: `flatness` is the distance, as
// a share of the depth, at which the weight is 0. Normals count with the 8th power of their cosine.
LUEUR_SHARED float bilateral_weight(vec3 position_p, vec3 normal_p, vec3 position_q, vec3 normal_q,
                                    float flatness) {
  const float distance_m = abs(dot(normal_p, position_q - position_p));
  const float near =
      max(1.0f + distance_m / (position_p.z * flatness), 0.0f);  // view z is negative
  float alike = max(dot(normal_p, normal_q), 0.0f);
  alike *= alike;
  alike *= alike;
  return near * alike * alike;
}

LUEUR_NAMESPACE_END

#endif
