// SPDX-License-Identifier: MIT
// Which pixels of a row a triangle covers, such that each pixel of a closed surface is covered an
// even number of times: exactly, not up to rounding.
//
// A row is a plane through the eye. Each vertex is on one of its sides, whatever triangle asks, so
// that a triangle has two edges that cross it, or none. Where an edge crosses is computed from its
// two ends in one order, whatever triangle asks, and the pixels between the two crossings are
// covered. So pixel after pixel along a row, an edge turns both its triangles over, or neither.
// Vertices behind the eye need no clipping for that; only the part of the row in front counts.

// True if a comes before b in some order of points.
bool precedes(vec3 a, vec3 b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

// Where the row is on the side of v, positive or not.
float beside_row(vec3 v, float row_px) {
  precise const float side = v.y - row_px * v.z;
  return side;
}

// x and z of the point where the edge crosses the row.
vec2 row_crossing(vec3 from, vec3 to, float row_px) {
  const bool in_order = precedes(from, to);
  const vec3 a = in_order ? from : to;
  const vec3 b = in_order ? to : from;
  const float side_a = beside_row(a, row_px);
  precise const float t = side_a / (side_a - beside_row(b, row_px));
  precise const vec2 point = a.xz + (b.xz - a.xz) * t;
  return point;
}

// The first pixel whose centre is not left of the position.
int first_pixel(float position_px, int width) {
  return int(ceil(clamp(position_px, -1.0, float(width) + 1.0) - 0.5));
}

// The first pixel of a row, and the one behind the last.
ivec2 row_span(Triangle t, int row, int width, float z_clip) {
  const float row_px = float(row) + 0.5;
  const bool a = beside_row(t.a, row_px) >= 0.0;
  const bool b = beside_row(t.b, row_px) >= 0.0;
  const bool c = beside_row(t.c, row_px) >= 0.0;
  if (a == b && b == c) return ivec2(0);
  // The vertex that is alone on its side.
  const vec3 apex = b == c ? t.a : (c == a ? t.b : t.c);
  vec2 p = row_crossing(apex, b == c ? t.b : (c == a ? t.c : t.a), row_px);
  vec2 q = row_crossing(apex, b == c ? t.c : (c == a ? t.a : t.b), row_px);
  if (p.y < z_clip && q.y < z_clip) return ivec2(0);
  const vec2 clipped = p + (q - p) * ((z_clip - p.y) / (q.y - p.y));
  if (p.y < z_clip) p = vec2(clipped.x, z_clip);
  if (q.y < z_clip) q = vec2(clipped.x, z_clip);
  const int one = first_pixel(p.x / p.y, width);
  const int other = first_pixel(q.x / q.y, width);
  return clamp(ivec2(min(one, other), max(one, other)), 0, width);
}

// The first row that a triangle may touch, and the one behind the last. Empty if it cannot be seen.
ivec2 rows_of(Triangle t, ivec2 extent, float z_clip) {
  const vec3 x = vec3(t.a.x, t.b.x, t.c.x);
  const vec3 y = vec3(t.a.y, t.b.y, t.c.y);
  const vec3 z = vec3(t.a.z, t.b.z, t.c.z);
  if (all(lessThan(z, vec3(z_clip))) || all(lessThan(x, vec3(0.0))) ||
      all(greaterThan(x, float(extent.x) * z)))
    return ivec2(0);
  if (any(lessThan(z, vec3(z_clip)))) return ivec2(0, extent.y);
  // Rows by their centres, with room for the division's rounding.
  const vec3 y_px = clamp(y / z, -1.0, float(extent.y) + 1.0);
  return clamp(ivec2(ceil(min(min(y_px.x, y_px.y), y_px.z) - 0.51),
                     ceil(max(max(y_px.x, y_px.y), y_px.z) - 0.49)),
               0, extent.y);
}
