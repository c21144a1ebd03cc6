// SPDX-License-Identifier: MIT
// Radiance that reaches the eye through glossy lobes from the level's ring, for a lobe of colour 1:
// FDP 4, "screen-space importance sampling". Samples are drawn around where the lobe leads on the
// screen. The including shader says what is seen, with a constant march_rays, 1 or 0, and
//   float visibility(vec2 at_px, float z, ivec2 q, float z_of_patch)

// 0: all azimuths alike.
layout(constant_id = 0) const uint importance = 1;
layout(local_size_x = 32, local_size_y = 3) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D geometry;
layout(set = 0, binding = 1, rgba16f) uniform readonly image2D source;
layout(set = 0, binding = 2, r16f) uniform readonly image2D lobe;  // of level 0
layout(set = 0, binding = 3, scalar) readonly buffer Lobes { CosineLobeData data[]; } lobes;
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D glossy;
layout(push_constant, scalar) uniform Push { GatherParams p; };

#include "shading/lobe.glsl"

float visibility(vec2 at_px, float z, ivec2 q, float z_of_patch);

// Where on the screen, seen from its pixel, a point goes that leaves `position` along `direction`;
// in pixels, per unit of way.
vec2 way_on_screen(Screen screen, vec3 position, vec3 direction) {
  const float z = -position.z;
  return (direction.xy + position.xy / z * direction.z) / (z * screen.ray_scale);
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, p.extent))) return;
  const vec4 g = imageLoad(geometry, pixel);
  if (g.w <= 0.0) {
    imageStore(glossy, pixel, vec4(0.0));
    return;
  }
  const vec2 ray = ray_through(p.screen, vec2(pixel) + 0.5);
  const vec3 position = position_view(ray, g.w);
  const vec3 to_eye = -normalize(position);
  const ivec2 in_level_0 = (pixel << p.level) + (1 << p.level) / 2;
  const Lobe l = lobe_of(imageLoad(lobe, min(in_level_0, imageSize(lobe) - 1)).r);

  // The peak's way on the screen, over what it would be if the peak was parallel to the screen:
  // near 0 the lobe leads to or from the eye, and no azimuth is better than another.
  const vec3 peak = cosine_lobe_axis(l.c_xy, l.c_z, g.xyz, to_eye);
  const vec2 way = way_on_screen(p.screen, position, peak) * abs(p.screen.ray_scale) * g.w;
  const float sideways = clamp(dot(way, way), 0.0, 1.0);
  const float peak_rad = atan(way.y, way.x);
  const GlossyAzimuth f =
      glossy_azimuth(importance == 1 ? mix(1.0, l.exponent, sideways) : 1.0);

  const vec2 start = spiral_start(uvec2(pixel), p.level, p.seed, p.rotate != 0);
  const float step_px2 = sample_step_px2(p.inner_px, p.outer_px, p.samples);
  vec3 light = vec3(0.0);
  float taken = 0.0;
  for (uint i = 0; i < p.samples; ++i) {
    const float u = fract(start.y + float(i) * 0.6180339887);
    const float turn = importance == 1 ? glossy_sample(f, u) : kTurn * (u - 0.5);
    const float azimuth = peak_rad + turn;
    // Pixels that the sample stands for, over those that each of evenly placed ones would.
    const float weight = importance == 1 ? 1.0 / (kTurn * glossy_density(f, turn)) : 1.0;
    const float radius_px = sample_radius_px(p.inner_px, step_px2, float(i) + start.x);
    const vec2 offset = floor(vec2(cos(azimuth), sin(azimuth)) * radius_px + 0.5);
    const ivec2 q = pixel + ivec2(offset);
    const vec4 surface = imageLoad(geometry, q);
    const vec4 s = imageLoad(source, q);
    taken += all(lessThan(uvec2(q), uvec2(p.source_extent))) ? 1.0 : 0.0;
    const vec3 to_patch =
        position_view(ray + offset * p.screen.ray_scale, surface.w) - position;
    const float area_over_pi = weight * p.area_over_pi * surface.w * surface.w * s.a;  // HSSIL (2)
    const float factor = disc_form_factor(to_patch, g.xyz, surface.xyz, area_over_pi);
    const bool gives = factor * (s.r + s.g + s.b) > 0.0;
    if (!gives || (march_rays == 1 && visibility(vec2(pixel) + 0.5, g.w, q, surface.w) == 0.0))
      continue;
    const vec3 to_light = normalize(to_patch);
    const float solid_angle_sr = kPi * factor / max(dot(g.xyz, to_light), 1.0e-4);
    // f cos(theta) cos(theta') ds / r^2 = f pi F.
    light += s.rgb * (kPi * factor * lobe_brdf(l, g.xyz, to_light, to_eye, solid_angle_sr));
  }
  imageStore(glossy, pixel,
             vec4(min(light, vec3(65504.0)), 1.0 - taken / float(p.samples)));
}
