// SPDX-License-Identifier: MIT
// A light where its node puts it, ready for the formulas of shading/punctual_light.h.
#pragma once

#include "lueur/host.h"
#include "scene/scene.h"

namespace lueur {

struct PlacedLight {
  LightKind kind = LightKind::point;
  glm::vec3 position_world{0.0f};
  glm::vec3 direction_world{0.0f, -1.0f, 0.0f};  // unit: in which it shines (spot, directional)
  glm::vec3 intensity{0.0f};                     // cd or lux, times colour
  float inner_cone_rad = 0.0f;                   // half angles, spot only
  float outer_cone_rad = 0.0f;
  // Of cone_attenuation(); 0 and 1, which is no attenuation, for all but spots.
  float cone_scale = 0.0f;
  float cone_offset = 1.0f;
  float inverse_range = 0.0f;  // of range_window(), 1/m; 0: no range
};

// Cones are at least 0.01 rad and less than pi / 2 wide, as the extension asks for.
PlacedLight place(const Light& light, const glm::mat4& world_from_node);

// The same as techniques have it.
PunctualLight as_punctual(const PlacedLight& light);

}  // namespace lueur
