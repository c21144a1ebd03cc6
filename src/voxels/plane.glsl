// SPDX-License-Identifier: MIT
// Where a triangle's plane is in the columns of voxels, the same for both voxelizers.

// The triangle's plane on the screen, where 1 / z is linear.
struct Plane {
  vec2 at_px;     // a point on the screen, its 1 / z
  float inverse_z;
  vec2 gradient;  // of 1 / z, a pixel
  vec2 bounds;    // least and greatest 1 / z of the triangle's visible part
};

// First and last slice of a pixel's column where the plane is within `reach_px` of the pixel's
// centre in x and y. Those outside of the grid are not among them, and first > last says that none
// is inside.
ivec2 slices_of(VoxelRange range, Plane plane, vec2 position_px, float reach_px) {
  precise const float inverse_z =
      plane.inverse_z + dot(plane.gradient, position_px - plane.at_px);
  const float reach = reach_px * (abs(plane.gradient.x) + abs(plane.gradient.y));
  const vec2 ends = 1.0 / clamp(inverse_z + vec2(reach, -reach), plane.bounds.x, plane.bounds.y);
  const float slices = float(range.slices);
  const float first = clamp(floor(slice_place(range, ends.x)), -1.0, slices);
  const float last = clamp(floor(slice_place(range, ends.y)), -1.0, slices - 1.0);
  return ivec2(max(int(first), 0), int(last));
}
