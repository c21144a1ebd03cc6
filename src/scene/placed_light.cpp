// SPDX-License-Identifier: MIT
#include "scene/placed_light.h"

#include <algorithm>
#include <cmath>

namespace lueur {
namespace {

constexpr float kNarrowestConeRad = 0.01f;
constexpr float kWidestConeRad = 1.5707f;

}  // namespace

PlacedLight place(const Light& light, const glm::mat4& world_from_node) {
  PlacedLight placed;
  placed.kind = light.kind;
  placed.position_world = glm::vec3(world_from_node[3]);
  const glm::vec3 axis = -glm::vec3(world_from_node[2]);
  if (glm::length(axis) > 0.0f) placed.direction_world = glm::normalize(axis);
  placed.intensity = light.color * light.intensity;
  if (light.kind != LightKind::directional) placed.inverse_range = 1.0f / light.range_m;
  if (light.kind != LightKind::spot) return placed;
  const float outer = std::clamp(light.outer_cone_rad, kNarrowestConeRad, kWidestConeRad);
  const float inner = std::clamp(light.inner_cone_rad, 0.0f, outer - 1e-3f);
  placed.inner_cone_rad = inner;
  placed.outer_cone_rad = outer;
  placed.cone_scale = 1.0f / std::max(1e-3f, std::cos(inner) - std::cos(outer));
  placed.cone_offset = -std::cos(outer) * placed.cone_scale;
  return placed;
}

}  // namespace lueur
