// SPDX-License-Identifier: MIT
// What the passes get from the CPU, and the lights as they hand them on.
#ifndef LUEUR_TECHNIQUES_INDIRECT_LIGHTS_PARAMS_H
#define LUEUR_TECHNIQUES_INDIRECT_LIGHTS_PARAMS_H

#include "techniques/camera_params.h"

LUEUR_NAMESPACE_BEGIN

// A patch that shines, in the camera's view space. Negative ones have negative radiance, and along
// their "normal" goes the light that they take away.
struct IndirectLight {
  vec3 position;
  float area_over_pi;  // m^2
  vec3 normal_area;    // unit normal times area_over_pi
  vec3 radiance;
};

// A ray of a light in one of its views, and which of the lights it makes.
struct PlacedRay {
  vec2 at_px;
  float solid_angle_sr;
  uint slot;
};

struct PlaceParams {
  Screen screen;  // of the light's view
  mat4 camera_from_view;
  mat3 camera_from_world;
  mat3 view_from_world;
  uint rays;
};

struct NegativeParams {
  CameraParams camera;
  uint lights;    // the positive ones, from slot 0
  uint negative;  // how many of others, from slot `lights`
};

struct GatherParams {
  CameraParams camera;
  ivec2 extent;  // pixels that gather
  int factor;    // pixels of the G-buffer a side of one of them
  uint lights;   // of both signs
};

struct InterpolateParams {
  CameraParams camera;
  ivec2 low_extent;
  int factor;
  float discontinuity;
};

struct RefineParams {
  CameraParams camera;
  uint lights;
};

LUEUR_NAMESPACE_END

#endif
