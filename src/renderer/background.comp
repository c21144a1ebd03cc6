// SPDX-License-Identifier: MIT
// Shows the environment where there is no surface, or everywhere.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "renderer/params.h"
#include "shading/environment.h"

// Rows, as texel fetches like them; see prepare.comp of the hierarchical technique.
layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D environment;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D shown;
layout(push_constant, scalar) uniform Push {
  BackgroundParams p;
};

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  if (p.everywhere == 0 && texelFetch(depth, pixel, 0).r > 0.0) return;
  const vec2 centre = vec2(pixel) + 0.5;
  const vec2 uv = environment_uv(p.corner + centre.x * p.step_x + centre.y * p.step_y);
  // One level for the whole view: derivatives would jump at the seam.
  const vec3 radiance = p.intensity * textureLod(environment, uv, p.level).rgb;
  imageStore(shown, pixel, vec4(min(radiance, vec3(65504.0)), 1.0));
}
