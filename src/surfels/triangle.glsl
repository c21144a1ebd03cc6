// SPDX-License-Identifier: MIT
// Triangles in view space. The including shader binds `vertices`, `indices`, and has `p`, the
// SurfelizeParams.

#include "surfels/params.h"
#include "surfels/sampling.h"

mat3 triangle_at(SurfelRange range, uint triangle) {
  mat3 corners;
  for (uint i = 0; i < 3; ++i) {
    const int vertex =
        int(indices.data[range.first_index + 3 * triangle + i]) + range.vertex_offset;
    const uint first = p.first_float + uint(vertex) * p.stride_floats;
    const vec4 position = vec4(vertices.data[first], vertices.data[first + 1],
                               vertices.data[first + 2], 1.0);
    corners[i] = (range.view_from_object * position).xyz;
  }
  return corners;
}

// The point of a triangle that is nearest to the eye (Ericson, Real-Time Collision Detection, 5.1.5).
vec3 nearest_of(mat3 t) {
  const vec3 ab = t[1] - t[0], ac = t[2] - t[0];
  const float d1 = -dot(ab, t[0]), d2 = -dot(ac, t[0]);
  if (d1 <= 0.0 && d2 <= 0.0) return t[0];
  const float d3 = -dot(ab, t[1]), d4 = -dot(ac, t[1]);
  if (d3 >= 0.0 && d4 <= d3) return t[1];
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return t[0] + d1 / max(d1 - d3, 1e-20) * ab;
  const float d5 = -dot(ab, t[2]), d6 = -dot(ac, t[2]);
  if (d6 >= 0.0 && d5 <= d6) return t[2];
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return t[0] + d2 / max(d2 - d6, 1e-20) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return t[1] + (d4 - d3) / max(d4 - d3 + d5 - d6, 1e-20) * (t[2] - t[1]);
  const float sum = va + vb + vc;
  return sum > 1e-30 ? t[0] + ab * (vb / sum) + ac * (vc / sum) : t[0];
}

// Whether a ball is within margin_m of what the picture can show.
bool is_near_view(vec3 centre, float radius_m) {
  const vec2 a = ray_through(p.screen, vec2(0.0)), b = ray_through(p.screen, p.corner_px);
  const vec2 low = min(a, b), high = max(a, b);
  const vec2 below = (centre.xy + low * centre.z) / sqrt(1.0 + low * low);
  const vec2 above = -(centre.xy + high * centre.z) / sqrt(1.0 + high * high);
  const vec2 inside = min(below, above);
  return min(min(inside.x, inside.y), -centre.z) >= -(radius_m + p.margin_m);
}

// Around a triangle: centre and radius.
vec4 ball_around(mat3 t) {
  const vec3 centre = (t[0] + t[1] + t[2]) / 3.0;
  return vec4(centre, sqrt(max(max(dot(t[0] - centre, t[0] - centre),
                                   dot(t[1] - centre, t[1] - centre)),
                               dot(t[2] - centre, t[2] - centre))));
}
