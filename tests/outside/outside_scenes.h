// SPDX-License-Identifier: MIT
// Scenes that another renderer can be asked to render with nothing left to interpretation: plainly
// diffuse surfaces, or metal that reflects everything at every angle.
#pragma once

#include "scene/scene.h"

namespace lueur {

// The built-in `cornell` with the specular share of its materials taken out, lit by its spot or by
// the glow of its panel.
Scene cornell_lit_by_spot();
Scene cornell_lit_by_glow();

// A floor of albedo 0.5 at height 0, seen from straight above: the picture's height is 4 m of it,
// its left is -x, and its top is -z.
inline constexpr float kFloorAlbedo = 0.5f;
inline constexpr float kFloorHeight = 4.0f;  // m, of the picture
Scene floor_below(const Light& light, glm::vec3 place, glm::vec3 direction);

// A chequered floor and two walls in the sun and the light of a lamp, a box, a metal ball and a
// diffuse one.
Scene still_life();

}  // namespace lueur
