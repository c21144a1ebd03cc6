// SPDX-License-Identifier: MIT
#include "scene/placed_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lueur {
namespace {

constexpr float kNarrowestConeRad = 0.01f;
constexpr float kWidestConeRad = 1.5707f;

PunctualLight::Kind kind_of(LightKind kind) {
  switch (kind) {
    case LightKind::point:
      return PunctualLight::Kind::point;
    case LightKind::spot:
      return PunctualLight::Kind::spot;
    case LightKind::directional:
      return PunctualLight::Kind::directional;
  }
  return PunctualLight::Kind::point;
}

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

PunctualLight as_punctual(const PlacedLight& light) {
  const auto array_of = [](const glm::vec3& v) { return std::array{v.x, v.y, v.z}; };
  PunctualLight punctual{.kind = kind_of(light.kind),
                         .position = array_of(light.position_world),
                         .direction = array_of(light.direction_world),
                         .intensity = array_of(light.intensity)};
  if (light.kind == LightKind::spot) {
    punctual.inner_cone_rad = light.inner_cone_rad;
    punctual.outer_cone_rad = light.outer_cone_rad;
  }
  if (light.inverse_range > 0.0f) punctual.range_m = 1.0f / light.inverse_range;
  return punctual;
}

}  // namespace lueur
