// SPDX-License-Identifier: MIT
// LCM (3) for what lies outside of the picture: the texels of a map around the eye that the camera
// does not see.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "cube_maps/equations.h"
#include "techniques/hierarchical/params.h"

// Pixels that share the fetches of a texel, one below the other.
layout(constant_id = 0) const uint pixels_per_thread = 1;
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D light;
layout(set = 0, binding = 2, scalar) readonly buffer Texels { TexelLight data[]; } texels;
layout(set = 0, binding = 3, rgba16f) uniform writeonly image2D more;
layout(push_constant, scalar) uniform Push { OffScreenParams p; };

bool is_on_screen(vec3 position) {
  if (position.z >= 0.0) return false;
  const vec2 at_px =
      (position.xy / -position.z - p.picture_screen.ray_offset) / p.picture_screen.ray_scale;
  return all(greaterThan(at_px, vec2(0.0))) && all(lessThan(at_px, vec2(p.picture_extent)));
}

void main() {
  const ivec2 first = ivec2(gl_GlobalInvocationID.x, gl_WorkGroupID.y * pixels_per_thread);
  if (first.x >= p.extent.x) return;
  vec3 position[pixels_per_thread];
  vec3 normal[pixels_per_thread];
  vec3 sum[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = min(first + ivec2(0, k), p.extent - 1);
    const vec4 g = imageLoad(geometry, pixel);
    position[k] = position_view(ray_through(p.screen, vec2(pixel) + 0.5), g.w);
    normal[k] = g.w > 0.0 ? g.xyz : vec3(0.0);
    sum[k] = vec3(0.0);
  }
  for (uint i = 0; i < p.texels; ++i) {
    const TexelLight t = texels.data[i];
    if (is_on_screen(t.position)) continue;
    for (uint k = 0; k < pixels_per_thread; ++k) {
      const vec3 way = t.position - position[k];
      const float r2 = dot(way, way) + 1.0e-30;
      sum[k] += t.radiance *
                (max(dot(normal[k], way), 0.0) * inversesqrt(r2) * localized_share(t, r2));
    }
  }
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first + ivec2(0, k);
    if (pixel.y >= p.extent.y) break;
    const vec4 before = imageLoad(light, pixel);
    imageStore(more, pixel, vec4(min(before.rgb + sum[k], vec3(65504.0)), before.a));
  }
}
