// SPDX-License-Identifier: MIT
// What a map gives to a direction, convolved beforehand: square panoramas (octahedral, world space)
// side by side, first that of diffuse surfaces by their normal, then those of GGX lobes by the
// direction in which they mirror, from smooth to rough; the maps' one below the other.

#include "techniques/cube_map/params.h"

// The direction that a texel stands for.
vec3 direction_of(ivec2 texel) {
  return octahedral_decode((vec2(texel) + 0.5) / float(kPanoramaSide) * 2.0 - 1.0);
}

// Past an edge the square goes on from the same edge, mirrored.
ivec2 unfolded(ivec2 texel) {
  const int last = kPanoramaSide - 1;
  if (texel.x < 0 || texel.x > last) texel = ivec2(clamp(texel.x, 0, last), last - texel.y);
  if (texel.y < 0 || texel.y > last) texel = ivec2(last - texel.x, clamp(texel.y, 0, last));
  return texel;
}
