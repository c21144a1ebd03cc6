// SPDX-License-Identifier: MIT
// The including shader has `depth` and the constant `factor`.

// Of the image's pixels below one of level 0, the one on the surface that the level keeps.
ivec2 pixel_of_surface(ivec2 pixel, float z, Screen screen, ivec2 full_extent) {
  ivec2 best = min(pixel * factor, full_extent - 1);
  float least = 1.0e30;
  for (int i = 0; i < factor * factor; ++i) {
    const ivec2 child = min(pixel * factor + ivec2(i % factor, i / factor), full_extent - 1);
    const float distance_m = abs(z_from_depth(screen, texelFetch(depth, child, 0).r) - z);
    if (distance_m < least) best = child;
    least = min(least, distance_m);
  }
  return best;
}
