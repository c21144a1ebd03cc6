// SPDX-License-Identifier: MIT
// Triangles become bits of voxels. Solids toggle the one voxel of each crossing of a pixel's ray,
// from which fill.comp makes solid columns; shells set all voxels they touch. Thin solids are both,
// and set those of their crossings.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "voxels/params.h"
#include "voxels/slices.h"

layout(constant_id = 0) const uint shell = 0;  // 1: set, 0: toggle
layout(local_size_x = 64) in;                  // kChunkTriangles
layout(set = 0, binding = 0, scalar) readonly buffer Vertices { float data[]; } vertices;
layout(set = 0, binding = 1, scalar) readonly buffer Indices { uint data[]; } indices;
layout(set = 0, binding = 2, scalar) readonly buffer Ranges { RangeData data[]; } ranges;
layout(set = 0, binding = 3, scalar) readonly buffer Chunks { Chunk data[]; } chunks;
layout(set = 0, binding = 4, scalar) readonly buffer Range { VoxelRange value; } range;
layout(set = 0, binding = 5, r32ui) uniform uimage2D voxels;
layout(push_constant, scalar) uniform Push { ToggleParams p; };

#include "voxels/triangle.glsl"
#include "voxels/scanline.glsl"

// Rows from which on all threads share a triangle, and how many of them share a row.
const int kSharedRows = 24;
const uint kThreadsPerRow = 8;

shared uint shared_count;
shared Triangle shared_triangles[64];

void mark(VoxelRange grid, Plane plane, float reach_px, ivec2 pixel) {
  const ivec2 slices = slices_of(grid, plane, vec2(pixel) + 0.5, reach_px);
  const int first_texel = pixel.y * int(grid.slices / 32);
  if (shell == 0) {
    if (slices.x < int(grid.slices))
      imageAtomicXor(voxels, ivec2(pixel.x, first_texel + (slices.x >> 5)),
                     1u << uint(slices.x & 31));
    return;
  }
  for (int word = slices.x >> 5; word <= slices.y >> 5; ++word)
    imageAtomicOr(voxels, ivec2(pixel.x, first_texel + word),
                  slice_mask(word, slices.x, slices.y));
}

void main() {
  const uint chunk_index = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (chunk_index >= p.chunks) return;
  if (gl_LocalInvocationIndex == 0) shared_count = 0;
  barrier();

  const VoxelRange grid = range.value;
  const float z_clip = clip_z(grid);
  const Chunk chunk = chunks.data[chunk_index];
  const RangeData part = ranges.data[chunk.range];
  if (shell == 1 && !is_thin(grid, part.thickness_m)) return;
  const float reach_px = part.thickness_m == 0.0 ? kShellReachPx : 0.0;
  const uint triangle = chunk.first_triangle + gl_LocalInvocationIndex;
  ivec2 rows = ivec2(0);
  Triangle t = Triangle(vec3(0.0), vec3(0.0), vec3(0.0));
  if (triangle < part.triangle_count) {
    t = fetch_triangle(part, p.place, triangle);
    rows = rows_of(t, p.extent, z_clip);
  }
  if (rows.y - rows.x >= kSharedRows) {
    shared_triangles[atomicAdd(shared_count, 1u)] = t;
    rows = ivec2(0);
  }
  const Plane plane = plane_of(t, z_clip);
  for (int row = rows.x; row < rows.y; ++row) {
    const ivec2 span = row_span(t, row, p.extent.x, z_clip);
    for (int x = span.x; x < span.y; ++x) mark(grid, plane, reach_px, ivec2(x, row));
  }
  barrier();

  const uint count = shared_count;
  for (uint i = 0; i < count; ++i) {
    const Triangle large = shared_triangles[i];
    const Plane large_plane = plane_of(large, z_clip);
    const ivec2 large_rows = rows_of(large, p.extent, z_clip);
    const int row_step = int(kChunkTriangles / kThreadsPerRow);
    for (int row = large_rows.x + int(gl_LocalInvocationIndex / kThreadsPerRow);
         row < large_rows.y; row += row_step) {
      const ivec2 span = row_span(large, row, p.extent.x, z_clip);
      for (int x = span.x + int(gl_LocalInvocationIndex % kThreadsPerRow); x < span.y;
           x += int(kThreadsPerRow))
        mark(grid, large_plane, reach_px, ivec2(x, row));
    }
  }
}
