// SPDX-License-Identifier: MIT
// The things of the graveyard. Each stands on y = 0 about the origin and looks to +z.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

struct GraveyardMaterials {
  int32_t stone, granite, slab, brick, mortar, iron, bark, grass, earth, feathers, wax, flame, sky;
};

// Tombstones, upright or lying, 1 to 2 m high.
enum class Tombstone { round, pointed, shouldered, broken, cross, ringed_cross, obelisk, chest };
inline constexpr int kTombstones = 8;
void add_tombstone(MeshBuilder& builder, const GraveyardMaterials& materials, Tombstone kind);

// A chapel for a family's dead, 5 m wide, its door open; inside lies a chest.
void add_crypt(MeshBuilder& builder, const GraveyardMaterials& materials);

// A wall along x of bricks that stand out by different amounts, its top fallen in.
inline constexpr float kBrickWallLength = 7.6f;  // m, about the origin
void add_brick_wall(MeshBuilder& builder, const GraveyardMaterials& materials);

// A length of iron fence from x = 0 to kFencePanel, and the pillar that stands between two.
inline constexpr float kFencePanel = 1.8f;
void add_fence_panel(MeshBuilder& builder, const GraveyardMaterials& materials);
void add_fence_pillar(MeshBuilder& builder, const GraveyardMaterials& materials);

// A post with a hook at kHook, and what hangs on it, below the origin. The light comes from
// kLanternLight.
inline constexpr glm::vec3 kHook{-0.34f, 1.72f, 0};
inline constexpr glm::vec3 kLanternLight{0, -0.27f, 0};
void add_lantern_post(MeshBuilder& builder, const GraveyardMaterials& materials);
void add_lantern(MeshBuilder& builder, const GraveyardMaterials& materials);
void add_candle(MeshBuilder& builder, const GraveyardMaterials& materials);  // 0.2 m

// A raven, 0.4 m long, head to +z; its feet are at the origin.
void add_raven(MeshBuilder& builder, const GraveyardMaterials& materials);

// A bare tree; each seed gives another one.
void add_tree(MeshBuilder& builder, const GraveyardMaterials& materials, uint32_t seed);

// The ground: its height at a place, and the whole of it. Grass is given in tufts.
inline constexpr float kGroundHalfWidth = 14.0f, kGroundBack = -14.0f, kGroundFront = 11.0f;
float ground_height(float x, float z);
float path_center(float z);  // x of the way to the crypt
void add_ground(MeshBuilder& builder, const GraveyardMaterials& materials);
void add_path(MeshBuilder& builder, const GraveyardMaterials& materials);
void add_grass_tuft(MeshBuilder& builder, const GraveyardMaterials& materials, glm::vec3 place,
                    uint32_t seed);

}  // namespace lueur::builtin
