// SPDX-License-Identifier: MIT
// Light that another view, or the same one a frame ago, has for a point. The including shader binds
// that view's level 0: `geometry_there` and `light_there`.

struct Resampled {
  vec4 light;
  bool is_known;  // false: the view did not see the point
};

// The view's Screen is that of its G-buffer, `at_px` the point's place in its level 0, of which a
// pixel has `factor` of the G-buffer's a side. Position and normal are in its view space.
Resampled resample(Screen screen, vec2 at_px, float factor, vec3 position, vec3 normal) {
  const vec2 at = at_px - 0.5;
  const ivec2 corner = ivec2(floor(at));
  const vec2 f = at - vec2(corner);
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    // Outside of the image z loads as 0 (robustImageAccess): nothing is known of it.
    const ivec2 q = corner + ivec2(i & 1, i >> 1);
    const vec4 g = imageLoad(geometry_there, q);
    const vec2 bilinear = mix(1.0 - f, f, vec2(i & 1, i >> 1));
    const vec3 there = position_view(ray_through(screen, (vec2(q) + 0.5) * factor), g.w);
    const float same =
        g.w > 0.0 ? bilateral_weight(position, normal, there, g.xyz, kSameSurface) : 0.0;
    const float weight = same > 0.25 ? bilinear.x * bilinear.y : 0.0;
    sum += weight * imageLoad(light_there, q);
    weights += weight;
  }
  return weights > 0.01 ? Resampled(sum / weights, true) : Resampled(vec4(0.0), false);
}
