// SPDX-License-Identifier: MIT
// SOL 3.5: a pixel takes the light of the pixels at low resolution around it whose surface is its
// own. Where the nearest one's is not, it is put on the list of those to gather for.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;

#include "techniques/indirect_lights/surface.glsl"

layout(set = 0, binding = 2, rgba16f) uniform readonly image2D low_diffuse;
layout(set = 0, binding = 3, rgba32f) uniform readonly image2D low_geometry;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D diffuse;
layout(set = 0, binding = 5, scalar) buffer List { uint count; uint data[]; } list;
layout(set = 0, binding = 6, scalar) uniform Params { InterpolateParams value; } params;

shared uint shared_count;
shared uint shared_first;

// SOL 3.5's difference: of the normals, and of the positions as far as they are not in one plane,
// in shares of the distance. Infinite where one of them has no surface.
float difference(Surface s, vec4 low, vec3 low_position) {
  if (low.w == 0.0) return 1.0e30;
  const vec3 between = s.position - low_position;
  const float off_plane = max(abs(dot(s.normal, between)), abs(dot(low.xyz, between)));
  return max(length(s.normal - low.xyz), off_plane / -s.position.z);
}

void main() {
  const InterpolateParams p = params.value;
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (gl_LocalInvocationIndex == 0) shared_count = 0;
  barrier();

  const bool is_inside = all(lessThan(pixel, p.camera.extent));
  bool is_listed = false;
  if (is_inside) {
    const Surface s = surface_at(p.camera, pixel);
    vec4 sum = vec4(0.0);
    if (s.is_there) {
      const vec2 at = (vec2(pixel) - float(p.factor / 2)) / float(p.factor);
      const ivec2 corner = ivec2(floor(at));
      const vec2 part = at - vec2(corner);
      float nearest = 0.0;
      for (int i = 0; i < 4; ++i) {
        const ivec2 side = ivec2(i & 1, i >> 1);
        const ivec2 low = clamp(corner + side, ivec2(0), p.low_extent - 1);
        const vec4 g = imageLoad(low_geometry, low);
        const vec2 fine = vec2(min(low * p.factor + p.factor / 2, p.camera.extent - 1)) + 0.5;
        const vec3 position = position_view(ray_through(p.camera.screen, fine), g.w);
        const vec2 share = mix(1.0 - part, part, vec2(side));
        const float weight = share.x * share.y;
        const bool fits = difference(s, g, position) <= p.discontinuity;
        if (fits) sum += weight * vec4(imageLoad(low_diffuse, low).rgb, 1.0);
        // The corresponding one has the greatest weight.
        if (weight > nearest) {
          nearest = weight;
          is_listed = !fits;
        }
      }
      sum = is_listed ? vec4(0.0) : sum / max(sum.a, 1.0e-6);
    }
    imageStore(diffuse, pixel, vec4(sum.rgb, 0.0));
  }
  uint place = 0;
  if (is_listed) place = atomicAdd(shared_count, 1u);
  barrier();
  if (gl_LocalInvocationIndex == 0 && shared_count > 0)
    shared_first = atomicAdd(list.count, shared_count);
  barrier();
  if (is_listed) list.data[shared_first + place] = uint(pixel.y) << 16 | uint(pixel.x);
}
