// SPDX-License-Identifier: MIT
// How normals and depth are stored in a G-buffer.
#ifndef LUEUR_SHADING_PACKING_H
#define LUEUR_SHADING_PACKING_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

LUEUR_SHARED vec2 sign_not_zero(vec2 v) {
  return vec2(v.x >= 0.0f ? 1.0f : -1.0f, v.y >= 0.0f ? 1.0f : -1.0f);
}

// Octahedral map: the sphere onto [-1, 1]², by Meyer et al., "On Floating-Point Normal Vectors",
// 2010. `n` is a unit vector.
LUEUR_SHARED vec2 octahedral_encode(vec3 n) {
  const vec2 p = vec2(n.x, n.y) / (abs(n.x) + abs(n.y) + abs(n.z));
  return n.z >= 0.0f ? p : (vec2(1.0f) - abs(vec2(p.y, p.x))) * sign_not_zero(p);
}

LUEUR_SHARED vec3 octahedral_decode(vec2 p) {
  vec3 n = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
  if (n.z < 0.0f) {
    const vec2 folded = (vec2(1.0f) - abs(vec2(n.y, n.x))) * sign_not_zero(vec2(n.x, n.y));
    n.x = folded.x;
    n.y = folded.y;
  }
  return normalize(n);
}

LUEUR_NAMESPACE_END

#endif
