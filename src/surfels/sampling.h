// SPDX-License-Identifier: MIT
// Where surfels lie on triangles, and how many of them: BZB 4.3 (Nalbach, Ritschel, Seidel 2015).
#ifndef LUEUR_SURFELS_SAMPLING_H
#define LUEUR_SURFELS_SAMPLING_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

const float kSurfelPi = 3.14159265358979f;
// A triangle is split into at most so many parts a side, and a part into so many fine surfels.
const uint kMostParts = 64u;
const uint kMostFine = 4096u;
// Parts are not longer than this share of their distance from the eye, so that the size of surfels
// on one of them is about the same.
const float kPartLength = 0.5f;

// PCG, as Jarzynski and Olano 2020 have it for shaders.
LUEUR_SHARED uint pcg(uint v) {
  const uint state = v * 747796405u + 2891336453u;
  const uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

LUEUR_SHARED float unit_of(uint v) {
  return float(v >> 8u) * (1.0f / 16777216.0f);
}

// The area that surfels at this distance from the eye shall have, m^2: discs of radius_px on the
// screen, there where it is looked at straight on. `pixel` is a pixel's side at distance 1.
LUEUR_SHARED float wanted_area(float radius_px, float pixel, float distance_m) {
  const float radius_m = radius_px * pixel * distance_m;
  return kSurfelPi * radius_m * radius_m;
}

// Parts a side of a triangle, a power of two so that they seldom change when the eye moves.
LUEUR_SHARED uint parts_of(float longest_edge_m, float nearest_m) {
  uint parts = 1u;
  while (parts < kMostParts && longest_edge_m > kPartLength * nearest_m * float(parts)) parts *= 2u;
  return parts;
}

// Fine surfels of a part: none larger than those wanted where it is nearest.
LUEUR_SHARED uint fine_of(float area_m2, float least_wanted_m2) {
  return uint(clamp(ceil(area_m2 / least_wanted_m2), 1.0f, float(kMostFine)));
}

// The i-th of a sequence that fills the unit cube evenly (Roberts' R3), from a start of its own for
// each triangle: two numbers for the place, one for whether the surfel is kept. The first ones stay
// where they are when there are more of them.
LUEUR_SHARED vec3 sample_of(uint start, uint i) {
  const vec3 first = vec3(unit_of(pcg(start)), unit_of(pcg(start ^ 0x68bc21ebu)),
                          unit_of(pcg(start ^ 0x02e5be93u)));
  return fract(first + float(i) * vec3(0.8191725134f, 0.6710436067f, 0.5497004779f));
}

// Evenly over a triangle, from two numbers between 0 and 1.
LUEUR_SHARED vec3 barycentric_of(vec2 u) {
  const float s = sqrt(u.x);
  return vec3(1.0f - s, s * (1.0f - u.y), s * u.y);
}

// The corners of part k of parts x parts, in shares of the triangle's: columns are corners.
LUEUR_SHARED mat3 corners_of_part(uint parts, uint k) {
  const uint row = uint(sqrt(float(k) + 0.5f));
  const uint in_row = k - row * row;
  const float side = 1.0f / float(parts);
  const float r = float(row) * side, j = float(in_row / 2u) * side;
  // P(r, j) = a + r (b - a) + j (c - b)
  const vec3 top = vec3(1.0f - r, r - j, j);
  const vec3 down = vec3(-side, side, 0.0f), along = vec3(0.0f, -side, side);
  return in_row % 2u == 0u ? mat3(top, top + down, top + down + along)
                           : mat3(top, top + down + along, top + along);
}

LUEUR_NAMESPACE_END

#endif
