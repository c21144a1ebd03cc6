// SPDX-License-Identifier: MIT
// What the passes get from the CPU.
#ifndef LUEUR_TECHNIQUES_CUBE_MAP_PARAMS_H
#define LUEUR_TECHNIQUES_CUBE_MAP_PARAMS_H

#include "techniques/camera_params.h"

LUEUR_NAMESPACE_BEGIN

// Of the panoramas of classical maps, see panorama.glsl.
const int kPanoramaSide = 32;
const int kRoughnesses = 6;  // perceptual: 0, 0.2, ... 1

struct BeginParams {
  ivec2 extent;
};

// Who takes how much of a map. A point's share of a probe falls linearly from 1 at the probe to 0
// at the next one, along each axis of the world; where there is no next one it stays 1.
struct MapShare {
  uint map;
  uint is_probe;
  vec3 centre;      // view space
  vec3 falls_up;    // along growing coordinates, 1/m
  vec3 falls_down;  // along falling ones
};

struct GatherParams {
  CameraParams camera;
  MapShare share;
  ivec2 first;  // pixels that may take of the map: first <= pixel < end
  ivec2 end;
  uint first_texel;  // texels that are taken: first_texel <= texel < end_texel
  uint end_texel;
  float blinn_exponent;  // 0: the surfaces' own lobes
};

struct FinishParams {
  ivec2 extent;
};

LUEUR_NAMESPACE_END

#endif
