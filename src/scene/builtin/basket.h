// SPDX-License-Identifier: MIT
// A woven basket and what grows, for the scene `basket`.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

inline constexpr float kBasketHeight = 0.82f;  // m
inline constexpr float kBasketRadius = 0.47f;  // at the top

// Stands on the floor around the y axis: wicker woven over and under upright stakes, a twisted rim,
// two handles (at ±x), filled with soil.
void add_wicker(MeshBuilder& builder, int32_t wicker, int32_t soil);

// `count` arched leaves around the y axis that spring from `height_m`, `length_m` long or shorter.
struct Foliage {
  int count;
  float height_m;
  float length_m;
  float width_m;
  float rise;  // 0: flat, 1: steep
  uint32_t seed;
};
void add_foliage(MeshBuilder& builder, const Foliage& foliage);

// A round flower with petals, facing up.
void add_blossom(MeshBuilder& builder, glm::vec3 center, float radius_m);

// A thrown clay pot with a rim, `height_m` high, filled with soil.
void add_clay_pot(MeshBuilder& builder, int32_t clay, int32_t soil, float height_m);

}  // namespace lueur::builtin
