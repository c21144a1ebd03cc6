// SPDX-License-Identifier: MIT
// The including shader has `depth` and the constant `factor`.

// Of the image's pixels below one of level 0, one on the surface that the level keeps. Of 4 x 4,
// every other one is looked at, and the nearest to that surface is taken.
ivec2 pixel_of_surface(ivec2 pixel, float z, Screen screen, ivec2 full_extent) {
  const int stride = max(factor / 2, 1);
  const int side = factor / stride;
  ivec2 children[4];
  float d[4];
  for (int i = 0; i < side * side; ++i) {
    children[i] = min(pixel * factor + stride / 2 + stride * ivec2(i % side, i / side),
                      full_extent - 1);
    d[i] = texelFetch(depth, children[i], 0).r;
  }
  ivec2 best = children[0];
  float least = 1.0e30;
  for (int i = 0; i < side * side; ++i) {
    const float distance_m = abs(z_from_depth(screen, d[i]) - z);
    if (distance_m < least) best = children[i];
    least = min(least, distance_m);
  }
  return best;
}
