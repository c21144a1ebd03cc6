// SPDX-License-Identifier: MIT
// The things of the still life, ten times life size. Each stands on y = 0 about the origin and
// looks to +z. All use the builder's material.
#pragma once

#include <glm/glm.hpp>

#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

void add_vase(MeshBuilder& builder);         // 3.9 m; its pattern repeats kVaseRepeats times around
void add_bottle(MeshBuilder& builder);       // 4.6 m
void add_bowl(MeshBuilder& builder);         // 3.6 m wide; its inside begins at kBowlFloor
void add_candlestick(MeshBuilder& builder);  // 3.1 m
void add_candle_stump(MeshBuilder& builder);
void add_pear(MeshBuilder& builder);
void add_apple(MeshBuilder& builder);  // about the origin, radius kAppleRadius
void add_lemon(MeshBuilder& builder);  // lies along x about the origin
void add_stalk(MeshBuilder& builder, glm::vec3 from, glm::vec3 to, float radius_m);
void add_poppies(MeshBuilder& builder);  // dry stalks with seed heads, for the vase

inline constexpr float kVaseRadius = 1.12f;
inline constexpr int kVaseRepeats = 6;
inline constexpr float kBowlFloor = 0.42f;
inline constexpr float kAppleRadius = 0.5f;

// A skull without a lid to its openings: eyes, nose and mouth lead into the hollow head, where only
// light that comes through them arrives. 2.1 m long.
void add_skull(MeshBuilder& builder);

// One of the letters E, L, R and U as a solid, 2.2 m high, to be read from +z.
inline constexpr float kLetterHeight = 2.2f;
void add_letter(MeshBuilder& builder, char letter);

// The cloth on the table. Where objects stand it lies flat.
float cloth_height(float x, float z);
void add_table_cloth(MeshBuilder& builder);

}  // namespace lueur::builtin
