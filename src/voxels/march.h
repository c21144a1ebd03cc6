// SPDX-License-Identifier: MIT
// Whether a straight line between two points that a view sees is free, by walking through the
// voxels of one level (FDP section 4: "We always perform ray marching in the current mipmap
// level"). Compiles as C++ and as GLSL; the walk itself is march() in march.glsl.
//
// A point is (x, y, z): x and y in pixels of the level, the centre of the first pixel at 0.5, and z
// its distance along the optical axis. A line that is straight in space is straight in (x, y, 1/z).
// So x, y and 1/z advance in equal steps, and a step's z are exact.
#ifndef LUEUR_VOXELS_MARCH_H
#define LUEUR_VOXELS_MARCH_H

#include "shading/screen.h"
#include "voxels/slices.h"

LUEUR_NAMESPACE_BEGIN

// How far from its ends a line is not tested, in pixels of the level, and by how many slices it is
// moved towards the eye: both ends are seen, so that is away from their surfaces, into air.
struct MarchBias {
  float px;
  float slices;
};

// A point in view space, in front of the eye, as a march takes it.
LUEUR_SHARED vec3 march_point(Screen screen, vec3 position) {
  const float z = -position.z;
  const vec2 at_px = (vec2(position.x / z, position.y / z) - screen.ray_offset) / screen.ray_scale;
  return vec3(at_px.x, at_px.y, z);
}

// How far along a line, 0 to 1, a coordinate that is `from` at its beginning stays within 0 ..
// `size`.
LUEUR_SHARED float march_share_inside(float from, float to, float size) {
  const float room = to > from ? size - from : from;
  return clamp(room / max(abs(to - from), 1e-6f), 0.0f, 1.0f);
}

// Where the line from `from`, a point that is inside the picture, to `to` ends for a march: there,
// or where it leaves the picture, as nothing is known of what is outside. View space.
LUEUR_SHARED vec3 march_end(Screen screen, vec2 extent_px, vec3 from, vec3 to) {
  const float nearest = -1e-3f * from.z;
  if (-to.z < nearest) to = from + (to - from) * ((from.z + nearest) / (from.z - to.z));
  const vec3 begin = march_point(screen, from);
  const vec3 end = march_point(screen, to);
  const float share = min(march_share_inside(begin.x, end.x, extent_px.x),
                          march_share_inside(begin.y, end.y, extent_px.y));
  const float inverse_z = 1.0f / begin.z + (1.0f / end.z - 1.0f / begin.z) * share;
  return vec3(begin.x + (end.x - begin.x) * share, begin.y + (end.y - begin.y) * share,
              1.0f / inverse_z);
}

// What has shown good, see README.md.
const float kMarchBiasPx = 1.5f;
const float kMarchBiasSlices = 1.5f;
// A step looks into the column at its middle only, for the middle of the depths that it passes:
// this share of them. With all of them, the column's own slope counts as an obstacle; with none,
// steps pass through what is thin.
const float kMarchDepthShare = 0.5f;

// The walk, in steps of which each looks into the column at its middle.
struct March {
  vec2 middle_px;  // of the first step
  vec2 step_px;
  float inverse_z;       // at the middle of the first step, 1/m
  float inverse_z_step;  // per step
  float inverse_z_half;  // from a step's middle to the end of what it tests, 0 or more
  float bias_slices;
  int steps;  // 0: the points are too close for anything to be between them
};

// `max_steps` is 1 or more; no step is longer than a pixel if there are enough.
LUEUR_SHARED March march_between(vec3 from, vec3 to, int max_steps, MarchBias bias) {
  const vec2 along_px = vec2(to.x - from.x, to.y - from.y);
  const float length_px = length(along_px);
  const float tested_px = length_px - 2.0f * bias.px;
  March m;
  m.bias_slices = bias.slices;
  m.steps = tested_px > 0.0f ? clamp(int(tested_px) + 1, 1, max_steps) : 0;
  // Shares of the whole line: of a step, and where the first one has its middle.
  const float unit = 1.0f / max(length_px, 1e-6f);
  const float step = tested_px * unit / float(max(m.steps, 1));
  const float middle = bias.px * unit + 0.5f * step;
  const float inverse_from = 1.0f / from.z;
  const float inverse_along = 1.0f / to.z - inverse_from;
  m.middle_px = vec2(from.x, from.y) + along_px * middle;
  m.step_px = along_px * step;
  m.inverse_z = inverse_from + inverse_along * middle;
  m.inverse_z_step = inverse_along * step;
  m.inverse_z_half = abs(m.inverse_z_step) * (0.5f * kMarchDepthShare);
  return m;
}

// First and last slice that a step tests. First > last: the line is in front of the grid there.
LUEUR_SHARED ivec2 march_slices(VoxelRange range, March m, int step) {
  const float z = 1.0f / (m.inverse_z + m.inverse_z_step * float(step));
  const float middle = slice_place(range, z) - m.bias_slices;
  // d z = z^2 d (1/z); a second and third division would take as long as all the rest.
  const float half_span = z * z * m.inverse_z_half * range.slices_per_m;
  const int first = max(int(floor(middle - half_span)), 0);
  const int last = min(int(floor(middle + half_span)), int(range.slices) - 1);
  return ivec2(first, last);
}

LUEUR_SHARED ivec2 march_pixel(March m, int step) {
  const vec2 at_px = floor(m.middle_px + m.step_px * float(step));
  return ivec2(int(at_px.x), int(at_px.y));
}

LUEUR_NAMESPACE_END

#endif
