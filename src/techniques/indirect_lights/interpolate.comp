// SPDX-License-Identifier: MIT
// SOL 3.5: a pixel takes the light of the pixels at low resolution around it whose surface is its
// own. Where the nearest one's is not, it is put on the list of those to gather for.
//
// A thread takes the pixels between four of low resolution, which they share. Its first pixel is
// the one that the first of the four stands for.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64, local_size_y = 1) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;

#include "techniques/indirect_lights/params.h"
#include "techniques/surface.glsl"

layout(set = 0, binding = 2, rgba16f) uniform readonly image2D low_diffuse;
layout(set = 0, binding = 3, rgba32f) uniform readonly image2D low_geometry;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D diffuse;
layout(set = 0, binding = 5, scalar) buffer List { uint count; uint data[]; } list;
layout(set = 0, binding = 6, scalar) uniform Params { InterpolateParams value; } params;

shared uint shared_count;
shared uint shared_first;

// A pixel at low resolution.
struct Low {
  vec3 position;
  vec3 normal;  // 0 where there is no surface
  vec3 light;
};

Low low_at(InterpolateParams p, ivec2 pixel) {
  const ivec2 low = clamp(pixel, ivec2(0), p.low_extent - 1);
  const vec2 fine = vec2(min(low * p.factor + p.factor / 2, p.camera.extent - 1)) + 0.5;
  const vec4 g = imageLoad(low_geometry, low);
  return Low(position_view(ray_through(p.camera.screen, fine), g.w), g.xyz,
             imageLoad(low_diffuse, low).rgb);
}

// SOL 3.5's difference: of the normals, and of the positions as far as they are not in one plane,
// in shares of the distance.
bool fits(Surface s, Low low, float discontinuity) {
  const vec3 between = s.position - low.position;
  const vec3 turned = s.normal - low.normal;
  const float off_plane = max(abs(dot(s.normal, between)), abs(dot(low.normal, between)));
  return dot(turned, turned) <= discontinuity * discontinuity &&
         off_plane <= discontinuity * -s.position.z && low.normal != vec3(0.0);
}

void main() {
  const InterpolateParams p = params.value;
  const ivec2 corner = ivec2(gl_GlobalInvocationID.xy) - 1;
  const ivec2 first = corner * p.factor + p.factor / 2;
  if (gl_LocalInvocationIndex == 0) shared_count = 0;
  barrier();

  Low low[4];
  for (int i = 0; i < 4; ++i) low[i] = low_at(p, corner + ivec2(i & 1, i >> 1));
  uint listed = 0;  // a bit a pixel
  for (int k = 0; k < p.factor * p.factor; ++k) {
    const ivec2 offset = ivec2(k % p.factor, k / p.factor);
    const ivec2 pixel = first + offset;
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, p.camera.extent))) continue;
    const Surface s = surface_at(p.camera, pixel);
    const vec2 part = vec2(offset) / float(p.factor);
    vec4 sum = vec4(0.0);
    float nearest = 0.0;
    bool is_listed = false;
    for (int i = 0; i < 4; ++i) {
      const vec2 share = mix(1.0 - part, part, vec2(i & 1, i >> 1));
      const float weight = share.x * share.y;
      if (weight == 0.0) continue;
      const bool is_own = fits(s, low[i], p.discontinuity);
      if (is_own) sum += weight * vec4(low[i].light, 1.0);
      // The corresponding one has the greatest weight.
      if (weight > nearest) {
        nearest = weight;
        is_listed = !is_own && s.is_there;
      }
    }
    const bool is_taken = s.is_there && !is_listed;
    imageStore(diffuse, pixel, vec4(is_taken ? sum.rgb / sum.a : vec3(0.0), 0.0));
    if (is_listed) listed |= 1u << k;
  }

  uint place = 0;
  if (listed != 0) place = atomicAdd(shared_count, bitCount(listed));
  barrier();
  if (gl_LocalInvocationIndex == 0 && shared_count > 0)
    shared_first = atomicAdd(list.count, shared_count);
  barrier();
  for (; listed != 0; listed &= listed - 1) {
    const int k = findLSB(listed);
    const ivec2 pixel = first + ivec2(k % p.factor, k / p.factor);
    list.data[shared_first + place++] = uint(pixel.y) << 16 | uint(pixel.x);
  }
}
