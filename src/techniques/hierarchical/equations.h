// SPDX-License-Identifier: MIT
// The papers' formulas that are the technique's own; form factors are in shading/form_factor.h.
#ifndef LUEUR_HIERARCHICAL_EQUATIONS_H
#define LUEUR_HIERARCHICAL_EQUATIONS_H

#include "techniques/interleaving.h"
#include "techniques/joint_filter.h"

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

// FDP 4, "temporal filtering": the largest share of the last frame, less where the picture moves
// fast and where lobes are narrow, as what a surface shows through a narrow lobe does not move with
// it. `exponent` is the cosine lobe's, 1 for diffuse surfaces; a lobe is about 1 / sqrt(exponent)
// wide.
LUEUR_SHARED float history_weight(float most, float moved_px, float exponent) {
  return most * exp(-moved_px * sqrt(exponent) / 200.0f);
}

// FDP 4, "screen-space importance sampling": around a receiver's pixel, samples are drawn by
// azimuth from
//   f(theta) = alpha + exp(-s (theta_r - theta)^2 / (2 pi)),   alpha = 0.1,
// theta_r being where the lobe's peak leads on the screen and s the lobe's exponent. The difference
// of angles is within -pi .. pi.
const float kGlossyFloor = 0.1f;
const float kTurn = 6.28318530717959f;

// Inverse of the error function for |x| < 1: M. Giles, "Approximating the erfinv function", 2010,
// to 5 digits.
LUEUR_SHARED float inverse_erf(float x) {
  float w = -log((1.0f - x) * (1.0f + x));
  if (w < 5.0f) {
    w -= 2.5f;
    float p = 2.81022636e-08f;
    p = 3.43273939e-07f + p * w;
    p = -3.5233877e-06f + p * w;
    p = -4.39150654e-06f + p * w;
    p = 0.00021858087f + p * w;
    p = -0.00125372503f + p * w;
    p = -0.00417768164f + p * w;
    p = 0.246640727f + p * w;
    p = 1.50140941f + p * w;
    return p * x;
  }
  w = sqrt(w) - 3.0f;
  float p = -0.000200214257f;
  p = 0.000100950558f + p * w;
  p = 0.00134934322f + p * w;
  p = -0.00367342844f + p * w;
  p = 0.00573950773f + p * w;
  p = -0.0076224613f + p * w;
  p = 0.00943887047f + p * w;
  p = 1.00167406f + p * w;
  p = 2.83297682f + p * w;
  return p * x;
}

// What a receiver's samples need to know of f. With the Gaussian's sigma^2 = pi / s, its integral
// over -pi .. pi is sqrt(2 pi) sigma erf(pi / (sigma sqrt(2))) = pi sqrt(2 / s) erf(sqrt(pi s /
// 2)).
struct GlossyAzimuth {
  float exponent;       // s, at least 1
  float gauss_end;      // erf(sqrt(pi s / 2))
  float uniform_share;  // of the integral of f
  float total;          // the integral of f
};

LUEUR_SHARED GlossyAzimuth glossy_azimuth(float exponent) {
  GlossyAzimuth f;
  f.exponent = max(exponent, 1.0f);
  // erf(x) to 5e-4: Abramowitz and Stegun, 7.1.27.
  const float x = sqrt(0.25f * kTurn * f.exponent);
  const float t = 1.0f + x * (0.278393f + x * (0.230389f + x * (0.000972f + x * 0.078108f)));
  f.gauss_end = 1.0f - 1.0f / (t * t * t * t);
  const float gauss = 0.5f * kTurn * sqrt(2.0f / f.exponent) * f.gauss_end;
  f.total = kTurn * kGlossyFloor + gauss;
  f.uniform_share = kTurn * kGlossyFloor / f.total;
  return f;
}

// theta - theta_r for a u in [0, 1).
LUEUR_SHARED float glossy_sample(GlossyAzimuth f, float u) {
  if (u < f.uniform_share) return kTurn * (u / f.uniform_share - 0.5f);
  const float v = (u - f.uniform_share) / (1.0f - f.uniform_share);
  return inverse_erf((2.0f * v - 1.0f) * f.gauss_end * 0.99999f) * sqrt(kTurn / f.exponent);
}

// Density of theta, 1 / rad: its integral over -pi .. pi is 1.
LUEUR_SHARED float glossy_density(GlossyAzimuth f, float difference_rad) {
  return (kGlossyFloor + exp(-f.exponent * difference_rad * difference_rad / kTurn)) / f.total;
}

// FDP (5): what neighbour j adds to the score of pixel i. The widths of the three Gaussians are not
// in the paper: one pixel, a cosine of 0.9, and 2 % of the depth.
LUEUR_SHARED float vote(float distance_px, float cos_normals, float z_difference, float z) {
  const float normals = (1.0f - cos_normals) / 0.1f;
  const float depths = z_difference / (0.02f * z);
  return exp(-0.5f * (distance_px * distance_px + normals * normals + depths * depths));
}

LUEUR_NAMESPACE_END

#endif
