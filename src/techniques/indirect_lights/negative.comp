// SPDX-License-Identifier: MIT
// SOL 3.3: points that the camera sees become lights that take away what would have gone through
// their surfaces.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "shading/halton.h"

layout(constant_id = 1) const uint bound = 1;
layout(local_size_x = 64) in;
layout(set = 0, binding = 0) uniform sampler2D depth;
layout(set = 0, binding = 1) uniform sampler2D normal;

#include "techniques/indirect_lights/params.h"
#include "techniques/surface.glsl"

layout(set = 0, binding = 2, scalar) buffer Lights { IndirectLight data[]; } lights;
layout(set = 0, binding = 3, scalar) uniform Params { NegativeParams value; } params;

void main() {
  const NegativeParams p = params.value;
  const uint i = gl_GlobalInvocationID.x;
  if (i >= p.negative) return;
  const CameraParams camera = p.camera;
  const ivec2 pixel = min(ivec2(halton_2_3(i + 1) * vec2(camera.extent)), camera.extent - 1);
  const Surface s = surface_at(camera, pixel);

  IndirectLight negative = IndirectLight(vec3(0.0), 0.0, vec3(0.0), vec3(0.0));
  if (s.is_there) {
    // What would arrive from behind, and on the average from where. The mean weighs a light by
    // what it gives.
    vec3 light = vec3(0.0);
    vec3 towards = vec3(0.0);
    for (uint k = 0; k < p.lights; ++k) {
      const IndirectLight l = lights.data[k];
      const vec3 to_light = l.position - s.position;
      const vec3 given = l.radiance * bounded_form_factor(to_light, -s.normal, l.normal_area,
                                                          bound == 1 ? l.area_over_pi : 0.0);
      light += given;
      towards += dot(given, vec3(0.2126, 0.7152, 0.0722)) *
                 to_light * inversesqrt(max(dot(to_light, to_light), 1.0e-30));
    }
    // The part of the picture that the point stands for.
    const vec2 ray = ray_through(camera.screen, vec2(pixel) + 0.5);
    const float z = -s.position.z;
    const float pixels = float(camera.extent.x) * float(camera.extent.y) / float(p.negative);
    const float area = z * z * abs(camera.screen.ray_scale.x * camera.screen.ray_scale.y) *
                       foreshortening(s.normal, ray, kMostForeshortening) * pixels;
    if (dot(towards, towards) > 0.0) {
      negative.position = s.position;
      negative.area_over_pi = area * 0.318309886;
      negative.normal_area = -normalize(towards) * negative.area_over_pi;
      negative.radiance = -light;
    }
  }
  lights.data[p.lights + i] = negative;
}
