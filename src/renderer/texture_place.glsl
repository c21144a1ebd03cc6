// SPDX-License-Identifier: MIT
// Texture coordinates are placed per vertex. In a fragment shader the transform would be read by
// helper invocations, too: where a driver gives those zeros, as Mesa's software rasterizer does for
// storage buffers, derivatives and with them mip levels go wrong along each triangle's edge.

vec2 placed(TexturePlacement place, vec2 uv, vec2 uv_2) {
  const vec2 at = place.uv_set == 0 ? uv : uv_2;
  return place.along_u * at.x + place.along_v * at.y + place.offset;
}
