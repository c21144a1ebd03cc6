// SPDX-License-Identifier: MIT
// A triangle on its way to voxels, the same for both voxelizers.
//
// Homogeneous pixel coordinates: a vertex v is seen at pixel position v.xy / v.z, and v.z is its
// distance along the optical axis. They are linear in space, also where v.z is 0 or negative.
//
// The shader that includes this declares the buffers `vertices` and `indices`.

#include "voxels/plane.glsl"

struct Triangle {
  vec3 a;
  vec3 b;
  vec3 c;
};

vec3 fetch_vertex(RangeData range, VertexPlace place, uint index_place) {
  const int vertex = int(indices.data[range.first_index + index_place]) + range.vertex_offset;
  const uint first = place.first_float + uint(vertex) * place.stride_floats;
  const vec4 position = vec4(vertices.data[first], vertices.data[first + 1],
                             vertices.data[first + 2], 1.0);
  // `precise`: the same vertex has to come out the same in each triangle that shares it.
  precise const vec3 seen = vec3(dot(range.row_x, position), dot(range.row_y, position),
                                 dot(range.row_z, position));
  return seen;
}

Triangle fetch_triangle(RangeData range, VertexPlace place, uint triangle) {
  return Triangle(fetch_vertex(range, place, 3 * triangle),
                  fetch_vertex(range, place, 3 * triangle + 1),
                  fetch_vertex(range, place, 3 * triangle + 2));
}

// Nearer than this, nothing is drawn: a small part of the distance of what is seen first.
float clip_z(VoxelRange range) { return range.z_near / 256.0; }

Plane plane_of(Triangle t, float z_clip) {
  // Seen from its farthest vertex, which is in front of the eye if anything of it is.
  vec3 origin = t.a.z >= t.b.z ? t.a : t.b;
  origin = origin.z >= t.c.z ? origin : t.c;
  Plane plane;
  plane.at_px = origin.xy / origin.z;
  const vec3 a = vec3(t.a.xy - plane.at_px * t.a.z, t.a.z);
  const vec3 b = vec3(t.b.xy - plane.at_px * t.b.z, t.b.z);
  const vec3 c = vec3(t.c.xy - plane.at_px * t.c.z, t.c.z);
  const vec3 normal = cross(b - a, c - a);
  plane.inverse_z = 1.0 / origin.z;
  // Seen edge-on it has no gradient, and stays within its bounds.
  plane.gradient = abs(normal.z) > 1e-20 ? normal.xy / normal.z * plane.inverse_z : vec2(0.0);
  plane.bounds = vec2(plane.inverse_z, 1.0 / max(min(min(t.a.z, t.b.z), t.c.z), z_clip));
  return plane;
}
