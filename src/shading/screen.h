// SPDX-License-Identifier: MIT
// From a pixel and its depth to a point in view space, for any perspective projection.
#ifndef LUEUR_SHADING_SCREEN_H
#define LUEUR_SHADING_SCREEN_H

#include "shading/gpu.h"

LUEUR_NAMESPACE_BEGIN

// What a pass needs of a projection. "z" is the distance along the optical axis, positive in front
// of the camera, in scene units.
struct Screen {
  vec2 ray_scale;   // a pixel position p (centre of the first: 0.5, 0.5) of the full image lies on
  vec2 ray_offset;  // the view-space ray (p * ray_scale + ray_offset, -1)
  float z_numerator;  // z = z_numerator / (depth + z_addend)
  float z_addend;
  float depth_of_nothing;  // the depth buffer's value where there is no surface
};

LUEUR_SHARED vec2 ray_through(Screen screen, vec2 position_px) {
  return position_px * screen.ray_scale + screen.ray_offset;
}

LUEUR_SHARED vec3 position_view(vec2 ray, float z) {
  return vec3(ray * z, -z);
}

LUEUR_SHARED float z_from_depth(Screen screen, float depth) {
  return screen.z_numerator / (depth + screen.z_addend);
}

LUEUR_NAMESPACE_END

#endif
