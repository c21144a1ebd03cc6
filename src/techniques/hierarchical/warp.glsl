// SPDX-License-Identifier: MIT
// The including shader says how narrow a lobe the light at a pixel of level 0 comes through:
//   float exponent_at(ivec2 pixel)
//
// W(F) of FDP (6): the last frame's result where this frame's surfaces were then, with the weight
// that it may have: 0 where they were not seen.
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

layout(constant_id = 0) const int factor = 2;
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D motion;
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 3, rgba32f) uniform readonly image2D geometry_there;
layout(set = 0, binding = 4, rgba16f) uniform readonly image2D light_there;  // a: frames in it
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D warped;      // a: weight
layout(set = 0, binding = 6, scalar) uniform Params { WarpParams value; } params;

#include "techniques/hierarchical/resample.glsl"
#include "techniques/hierarchical/surface_pixel.glsl"

float exponent_at(ivec2 pixel);

void main() {
  const WarpParams p = params.value;
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 g = imageLoad(geometry, pixel);
  if (g.w <= 0.0) {
    imageStore(warped, pixel, vec4(0.0));
    return;
  }

  const vec2 moved_px =
      texelFetch(motion, pixel_of_surface(pixel, g.w, p.screen, p.full_extent), 0).rg *
      vec2(p.full_extent);
  const vec2 centre_px = (vec2(pixel) + 0.5) * float(factor);
  const vec2 before_px = centre_px - moved_px;

  // The point and its normal as the last frame should have seen them. Along the axis, a moving
  // object counts as if it stood still: in one frame it comes hardly nearer.
  const vec3 position = position_view(ray_through(p.screen, centre_px), g.w);
  const float z_before = -(p.previous_view_from_view * vec4(position, 1.0)).z;
  const vec3 position_before = position_view(ray_through(p.previous, before_px), z_before);
  const vec3 normal_before = mat3(p.previous_view_from_view) * g.xyz;

  const Resampled before = resample(p.previous, before_px / float(factor), float(factor),
                                    position_before, normal_before);
  vec4 result = vec4(0.0);
  if (before.is_known) {
    const float frames = before.light.a;
    result = vec4(before.light.rgb,
                  min(frames / (frames + 1.0),
                      history_weight(p.most, length(moved_px), exponent_at(pixel))));
  }
  imageStore(warped, pixel, result);
}
