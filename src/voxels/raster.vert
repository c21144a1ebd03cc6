// SPDX-License-Identifier: MIT
// Draws a range of triangles with their planes. No vertex attributes: each vertex needs its whole
// triangle.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"
#include "voxels/slices.h"

layout(set = 0, binding = 0, scalar) readonly buffer Vertices { float data[]; } vertices;
layout(set = 0, binding = 1, scalar) readonly buffer Indices { uint data[]; } indices;
layout(set = 0, binding = 2, scalar) readonly buffer Range { VoxelRange value; } range;
layout(set = 0, binding = 3, scalar) uniform Params { RasterParams value; } params;
layout(push_constant, scalar) uniform Push { RasterDraw p; };
layout(location = 0) flat out vec2 plane_at_px;
layout(location = 1) flat out float plane_inverse_z;
layout(location = 2) flat out vec2 plane_gradient;
layout(location = 3) flat out vec2 plane_bounds;

#include "voxels/triangle.glsl"

void main() {
  const Triangle t =
      fetch_triangle(p.range, params.value.place, uint(gl_VertexIndex) / 3);
  if (p.is_shell == 1 && !is_thin(range.value, p.range.thickness_m)) {
    gl_Position = vec4(0.0, 0.0, -1.0, 1.0);  // outside
    return;
  }
  const float z_clip = clip_z(range.value);
  const Plane plane = plane_of(t, z_clip);
  plane_at_px = plane.at_px;
  plane_inverse_z = plane.inverse_z;
  plane_gradient = plane.gradient;
  plane_bounds = plane.bounds;
  const int corner = gl_VertexIndex % 3;
  const vec3 v = corner == 0 ? t.a : (corner == 1 ? t.b : t.c);
  // Clip space, with the near plane at z_clip and no far plane.
  gl_Position = vec4(2.0 * v.xy / vec2(params.value.extent) - v.z, v.z - z_clip, v.z);
}
