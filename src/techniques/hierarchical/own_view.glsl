// SPDX-License-Identifier: MIT
// Receivers that are pixels of the level itself: gather.glsl's receiver() and keep().

Receiver receiver(ivec2 pixel) {
  const vec4 surface = imageLoad(geometry, pixel);
  const vec2 at_px = vec2(pixel) + 0.5;
  return Receiver(at_px, at_px, position_view(ray_through(p.screen, at_px), surface.w),
                  surface.xyz);
}

void keep(ivec2 pixel, vec4 light) { imageStore(indirect, pixel, min(light, vec4(65504.0))); }
