// SPDX-License-Identifier: MIT
// Another camera's light, warped to this view and blended with max where depth and normal agree:
// HSSIL 5, "additional cameras".
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D light;
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D geometry_there;
layout(set = 0, binding = 3, rgba16f) uniform readonly image2D light_there;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D largest;
layout(set = 0, binding = 5, scalar) uniform Params { WarpViewParams value; } params;

#include "techniques/hierarchical/resample.glsl"

void main() {
  const WarpViewParams p = params.value;
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 g = imageLoad(geometry, pixel);
  vec4 result = imageLoad(light, pixel);
  const vec3 position = position_view(ray_through(p.screen, vec2(pixel) + 0.5), g.w);
  const vec3 there = (p.there_from_here * vec4(position, 1.0)).xyz;
  if (g.w > 0.0 && there.z < 0.0) {
    const vec2 at_px = (there.xy / -there.z - p.screen_there.ray_offset) / p.screen_there.ray_scale;
    const Resampled other =
        resample(p.screen_there, at_px, 1.0, there, mat3(p.there_from_here) * g.xyz);
    if (other.is_known) result.rgb = max(result.rgb, other.light.rgb);
  }
  imageStore(largest, pixel, result);
}
