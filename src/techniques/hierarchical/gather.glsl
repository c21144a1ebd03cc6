// SPDX-License-Identifier: MIT
// The light that reaches pixels from one ring of one level: HSSIL (4) and section 3.2.
//
// The including shader says who receives, from where, and what happens to the sum:
//   Receiver receiver(ivec2 pixel)
//   float visibility(Receiver r, ivec2 q, vec4 surface)   1: the patch of pixel q is seen
//   void keep(ivec2 pixel, vec4 light)
// It binds `geometry` and `source`, and has the parameters `g` of type GatherParams.

// Each thread takes several pixels of a column, three rows apart: they have the same place in the
// 3 x 3 cells of spiral_start(), hence the same offsets, and share the work of finding them.
layout(constant_id = 0) const uint pixels_per_thread = 1;
// 0: HSSIL (4), 1: HSSIL (3).
layout(constant_id = 1) const uint form_factor = 0;
layout(local_size_x = 32, local_size_y = 3) in;

// A point that gathers, in the space of the view that gives.
struct Receiver {
  vec2 centre_px;  // around which the rings lie
  vec2 at_px;      // where the point itself is
  vec3 position;
  vec3 normal;
};

Receiver receiver(ivec2 pixel);
float visibility(Receiver r, ivec2 q, vec4 surface);
void keep(ivec2 pixel, vec4 light);

void gather(GatherParams g) {
  const ivec2 first = ivec2(gl_WorkGroupID.xy) * ivec2(32, 3 * pixels_per_thread) +
                      ivec2(gl_LocalInvocationID.xy);
  if (first.x >= g.extent.x || first.y >= g.extent.y) return;

  Receiver receivers[pixels_per_thread];
  vec3 light[pixels_per_thread];
  float taken[pixels_per_thread];
  for (uint k = 0; k < pixels_per_thread; ++k) {
    receivers[k] = receiver(first + ivec2(0, 3 * k));
    light[k] = vec3(0.0);
    taken[k] = 0.0;
  }

  const vec2 start = spiral_start(uvec2(first), g.level, g.seed, g.rotate != 0);
  const float turn = start.y * 6.28318530718;
  vec2 direction = vec2(cos(turn), sin(turn));
  const mat2 golden_turn = mat2(cos(kGoldenAngle), sin(kGoldenAngle),
                                -sin(kGoldenAngle), cos(kGoldenAngle));
  const float step_px2 = sample_step_px2(g.inner_px, g.outer_px, g.samples);
  for (uint i = 0; i < g.samples; ++i) {
    const float radius_px = sample_radius_px(g.inner_px, step_px2, float(i) + start.x);
    const vec2 offset_px = direction * radius_px;
    direction = golden_turn * direction;
    // All loads first: they do not wait for each other's arithmetic (0.86 of the time on a CPU).
    // Outside of the image rgb is 0 (robustImageAccess): such a sample is black, and is counted.
    ivec2 q[pixels_per_thread];
    vec4 surface[pixels_per_thread];
    vec4 s[pixels_per_thread];
    for (uint k = 0; k < pixels_per_thread; ++k) {
      q[k] = ivec2(floor(receivers[k].centre_px + offset_px));
      surface[k] = imageLoad(geometry, q[k]);
      s[k] = imageLoad(source, q[k]);
      taken[k] += all(lessThan(uvec2(q[k]), uvec2(g.source_extent))) ? 1.0 : 0.0;
    }
    for (uint k = 0; k < pixels_per_thread; ++k) {
      const vec3 to_patch =
          position_view(ray_through(g.screen, vec2(q[k]) + 0.5), surface[k].w) -
          receivers[k].position;
      // HSSIL (2)
      const float area_over_pi = g.area_over_pi * surface[k].w * surface[k].w * s[k].a;
      const vec3 n = receivers[k].normal;
      const float factor = form_factor == 1
                               ? point_form_factor(to_patch, n, surface[k].xyz, area_over_pi)
                               : disc_form_factor(to_patch, n, surface[k].xyz, area_over_pi);
      vec3 arriving = s[k].rgb * factor;
      if (march_rays == 1 && arriving.r + arriving.g + arriving.b > 0.0)
        arriving *= visibility(receivers[k], q[k], surface[k]);
      light[k] += arriving;
    }
  }

  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first + ivec2(0, 3 * k);
    if (pixel.y < g.extent.y) keep(pixel, vec4(light[k], 1.0 - taken[k] / float(g.samples)));
  }
}
