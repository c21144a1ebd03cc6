// SPDX-License-Identifier: MIT
// Receivers of one view, as another view sees them: gather.glsl's receiver() and keep().

Receiver receiver(ivec2 pixel) {
  const vec4 surface = imageLoad(receivers, pixel);
  const vec3 position = position_view(
      ray_through(params.value.receiver_screen, vec2(pixel) + 0.5), surface.w);
  const vec3 there = (params.value.source_from_receiver * vec4(position, 1.0)).xyz;
  const Screen screen = params.value.gather.screen;
  // Behind the view: as far out as can be.
  const vec2 ray = there.xy / max(-there.z, 1.0e-4 * length(there) + 1.0e-30);
  const vec2 at_px = (ray - screen.ray_offset) / screen.ray_scale;
  const vec2 extent = vec2(params.value.gather.source_extent);
  return Receiver(clamp(at_px, vec2(0.0), extent),
                  clamp(at_px, -4.0 * extent, 5.0 * extent), there,
                  mat3(params.value.source_from_receiver) * surface.xyz);
}

void keep(ivec2 pixel, vec4 light) {
  const vec4 before = params.value.is_first == 1 ? vec4(0.0) : imageLoad(indirect, pixel);
  imageStore(indirect, pixel, vec4(min(before.rgb + light.rgb, vec3(65504.0)), before.a + light.a));
}
