// SPDX-License-Identifier: MIT
// Joint bilateral interpolation of a coarse level's light: `up` of HSSIL 3.2. Together with
// joint_filter.comp it makes the paper's 3 x 3 kernel, spread over the level's texels without steps.
//
// A thread takes the fine pixels between the centres of four coarse ones: they all interpolate
// between the same four, which are loaded once.
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

// Fine pixels a side of one coarse pixel.
layout(constant_id = 0) const int factor = 2;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;  // coarse
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D light;     // coarse

struct Corner {
  vec4 light;
  vec3 position;
  vec3 normal;
  float is_surface;
};

// The coarse pixel whose centre is the top left of the four; -1 at the image's edges.
ivec2 corner_base() { return ivec2(gl_GlobalInvocationID.xy) - 1; }

Corner load_corner(int i, ivec2 coarse_extent, vec2 coarse_scale, vec2 ray_offset) {
  const ivec2 q =
      clamp(corner_base() + ivec2(i & 1, i >> 1), ivec2(0), coarse_extent - 1);
  const vec4 g = imageLoad(geometry, q);
  return Corner(imageLoad(light, q),
                position_view((vec2(q) + 0.5) * coarse_scale + ray_offset, g.w), g.xyz,
                g.w > 0.0 ? 1.0 : 0.0);
}

// The i-th of the factor x factor fine pixels, and where it lies between the corners, in [0, 1].
// With factor 1 the fine pixel is the last corner itself.
ivec2 fine_pixel(int i) {
  if (factor == 1) return corner_base() + 1;
  return corner_base() * factor + factor / 2 + ivec2(i % factor, i / factor);
}
vec2 between_corners(int i) { return (vec2(i % factor, i / factor) + 0.5) / float(factor); }

vec4 interpolate(Corner corners[4], vec2 f, vec3 position, vec3 normal) {
  if (factor == 1) return corners[3].light;
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Corner c = corners[i];
    const vec2 bilinear = mix(1.0 - f, f, vec2(i & 1, i >> 1));
    // Where no coarse pixel is of the same surface, the plain interpolation remains.
    const float weight =
        (c.is_surface * bilateral_weight(position, normal, c.position, c.normal, kFlatness) +
         1.0e-4) *
        (bilinear.x * bilinear.y + 1.0e-4);
    sum += weight * c.light;
    weights += weight;
  }
  return sum / weights;
}
