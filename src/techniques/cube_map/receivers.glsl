// SPDX-License-Identifier: MIT
// The pixels of a thread, one below the other, and how much of the map each takes. The including
// shader binds `depth`, `normal`, `object`, `map_of_object`, and `sum`.

#include "techniques/surface.glsl"

// Pixels that share the fetches of a texel.
layout(constant_id = 0) const uint pixels_per_thread = 1;
// 0: nothing moves, and `object` is some image.
layout(constant_id = 1) const uint has_objects = 1;

struct Receivers {
  Surface surface[pixels_per_thread];
  float share[pixels_per_thread];
};

float share_of(MapShare m, Surface s, ivec2 pixel, mat3 view_from_world) {
  if (!s.is_there) return 0.0;
  const uint number =
      has_objects == 1 ? uint(texelFetch(object, pixel, 0).r * 255.0 + 0.5) : 0u;
  if (number > 0) return m.is_probe == 0 && map_of_object.data[number - 1] == m.map ? 1.0 : 0.0;
  if (m.is_probe == 0) return 0.0;
  const vec3 off = (s.position - m.centre) * view_from_world;  // world space
  const vec3 along = clamp(1.0 - max(off * m.falls_up, -off * m.falls_down), 0.0, 1.0);
  return along.x * along.y * along.z;
}

ivec2 first_pixel(GatherParams p) {
  return p.first + ivec2(gl_GlobalInvocationID.x, gl_WorkGroupID.y * pixels_per_thread);
}

void add_to_sum(ivec2 pixel, vec3 light, float share, bool is_first) {
  if (share == 0.0) return;
  const vec4 before = imageLoad(sum, pixel);
  imageStore(sum, pixel, before + vec4(light * share, is_first ? share : 0.0));
}

// False where none of them takes anything.
bool load_receivers(GatherParams p, out Receivers r) {
  float total = 0.0;
  for (uint k = 0; k < pixels_per_thread; ++k) {
    const ivec2 pixel = first_pixel(p) + ivec2(0, k);
    const bool is_inside = all(lessThan(pixel, p.end));
    r.surface[k] = surface_at(p.camera, min(pixel, p.camera.extent - 1));
    r.share[k] = is_inside ? share_of(p.share, r.surface[k], pixel, p.camera.view_from_world) : 0.0;
    total += r.share[k];
  }
  return total > 0.0;
}
