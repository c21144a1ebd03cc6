// SPDX-License-Identifier: MIT
// BZB figure 6b and c: fine surfels on each part, of which those are kept that stand for the area
// wanted where they lie. As A_fine / A of them are and each then has the area A, all together have
// the triangle's.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "surfels/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, scalar) readonly buffer Vertices { float data[]; } vertices;
layout(set = 0, binding = 1, scalar) readonly buffer Indices { uint data[]; } indices;
layout(set = 0, binding = 2, scalar) readonly buffer Ranges { SurfelRange data[]; } ranges;
layout(set = 0, binding = 3, scalar) readonly buffer Parts { uint count; TrianglePart data[]; } parts;
layout(set = 0, binding = 4, scalar) buffer Surfels { uint count; Surfel data[]; } list;
layout(push_constant, scalar) uniform Push { SurfelizeParams p; };

#include "surfels/triangle.glsl"

void main() {
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  const uint index = group * 64 + gl_LocalInvocationIndex;
  if (index >= min(parts.count, p.parts_capacity)) return;
  const TrianglePart part = parts.data[index];
  const mat3 t = triangle_at(ranges.data[part.range], part.triangle) *
                 corners_of_part(part.parts, part.part);
  const vec4 ball = ball_around(t);
  if (!is_near_view(ball.xyz, ball.w)) return;
  const vec3 across = cross(t[1] - t[0], t[2] - t[0]);
  const float area = 0.5 * length(across);
  if (!(area > 0.0)) return;
  const float nearest = max(length(nearest_of(t)), p.least_distance_m);
  const uint fine = fine_of(area, wanted_area(p.radius_px, p.pixel, nearest));
  const float fine_area = area / float(fine);
  const uint start = pcg(part.range + pcg(part.triangle + pcg(part.part)));
  for (uint i = 0; i < fine; ++i) {
    const vec3 u = sample_of(start, i);
    const vec3 position = t * barycentric_of(u.xy);
    const float distance_m = max(length(position), p.least_distance_m);
    // Never smaller than what it stands for, where a part has too few fine ones.
    const float wanted = max(wanted_area(p.radius_px, p.pixel, distance_m), fine_area);
    if (u.z * wanted >= fine_area) continue;
    const uint place = atomicAdd(list.count, 1u);
    if (place < p.surfels_capacity)
      list.data[place] = Surfel(position, sqrt(wanted / kSurfelPi), normalize(across), part.range);
  }
}
