// SPDX-License-Identifier: MIT
// A pixel of the camera's G-buffer as a point in its view space. The including shader binds `depth`
// and `normal`.

#include "shading/packing.h"
#include "techniques/camera_params.h"

struct Surface {
  vec3 position;
  vec3 normal;
  bool is_there;
};

Surface surface_at(CameraParams camera, ivec2 pixel) {
  const float d = texelFetch(depth, pixel, 0).r;
  const float z = z_from_depth(camera.screen, d);
  const vec3 n = camera.view_from_world * octahedral_decode(texelFetch(normal, pixel, 0).rg);
  return Surface(position_view(ray_through(camera.screen, vec2(pixel) + 0.5), z), n,
                 d != camera.screen.depth_of_nothing);
}
