// SPDX-License-Identifier: MIT
// SOL 3.1: where a ray of a light arrives, as that light's view shows it, there is an indirect light.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "shading/packing.h"
#include "techniques/indirect_lights/params.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;
layout(set = 0, binding = 2) uniform sampler2D source;
layout(set = 0, binding = 3, scalar) readonly buffer Rays { PlacedRay data[]; } rays;
layout(set = 0, binding = 4, scalar) buffer Lights { IndirectLight data[]; } lights;
layout(set = 0, binding = 5, scalar) uniform Params { PlaceParams value; } params;

void main() {
  const PlaceParams p = params.value;
  if (gl_GlobalInvocationID.x >= p.rays) return;
  const PlacedRay placed = rays.data[gl_GlobalInvocationID.x];
  const ivec2 pixel = min(ivec2(placed.at_px), textureSize(depth, 0) - 1);
  const float d = texelFetch(depth, pixel, 0).r;
  const vec3 n = octahedral_decode(texelFetch(normal, pixel, 0).rg);

  IndirectLight l = IndirectLight(vec3(0.0), 0.0, vec3(0.0), vec3(0.0));
  if (d != p.screen.depth_of_nothing) {
    // The pixel's centre, whose surface this is, though the ray goes through another part of it.
    const vec2 ray = ray_through(p.screen, vec2(pixel) + 0.5);
    const float z = z_from_depth(p.screen, d);
    const float stretch = length(vec3(ray, 1.0));
    // r^2 / cos(theta_i), with r = z |(ray, 1)|.
    const float area = placed.solid_angle_sr * z * z * stretch * stretch * stretch *
                       foreshortening(p.view_from_world * n, ray, kMostForeshortening);
    l.position = (p.camera_from_view * vec4(position_view(ray, z), 1.0)).xyz;
    l.area_over_pi = area * 0.318309886;
    l.normal_area = p.camera_from_world * n * l.area_over_pi;
    l.radiance = texelFetch(source, pixel, 0).rgb;
  }
  lights.data[placed.slot] = l;
}
