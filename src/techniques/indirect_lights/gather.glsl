// SPDX-License-Identifier: MIT
// SOL 3.2: what all indirect lights give to a thread's pixels. The including shader binds `lights`.

#include "shading/form_factor.h"

// Pixels that share the fetches of a light.
layout(constant_id = 0) const uint pixels_per_thread = 1;
// 0: the inverse square as it is.
layout(constant_id = 1) const uint bound = 1;

struct Receivers {
  vec3 position[pixels_per_thread];
  vec3 normal[pixels_per_thread];
  vec3 light[pixels_per_thread];
};

void gather(inout Receivers r, uint count) {
  for (uint k = 0; k < pixels_per_thread; ++k) r.light[k] = vec3(0.0);
  for (uint i = 0; i < count; ++i) {
    const IndirectLight l = lights.data[i];
    const float least_r2 = bound == 1 ? l.area_over_pi : 0.0;
    for (uint k = 0; k < pixels_per_thread; ++k)
      r.light[k] += l.radiance * bounded_form_factor(l.position - r.position[k], r.normal[k],
                                                     l.normal_area, least_r2);
  }
  // SOL 3.4: negative lights take away no more than there is.
  for (uint k = 0; k < pixels_per_thread; ++k) r.light[k] = max(r.light[k], vec3(0.0));
}
