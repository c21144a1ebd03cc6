// SPDX-License-Identifier: MIT
// Walls, floors, mouldings and surfaces of the scenes that play in a room.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/shapes.h"
#include "scene/scene.h"

namespace lueur::builtin {

Pattern plaster_pattern();  // near white, trowelled: coloured by the material
// Eight boards a repeat, staggered, grained between two tones.
Pattern board_pattern(glm::vec3 dark, glm::vec3 light);
inline constexpr glm::vec3 kOakDark{0.38f, 0.22f, 0.11f}, kOakLight{0.62f, 0.41f, 0.24f};
Pattern tile_pattern();  // 4 x 4 square tiles of pale stone with fine joints

// Adds a material that wears `pattern`, tinted by `tint`.
int32_t add_patterned_material(Scene& scene, const std::string& name, glm::vec3 tint,
                               float roughness, uint32_t size, float size_m,
                               const Pattern& pattern);

// The same surface in another colour: shares the textures of `material`.
int32_t add_tinted_material(Scene& scene, const std::string& name, int32_t material,
                            glm::vec3 tint);

// Inner faces of a room and what they are made of; kNone leaves a side to the caller.
struct Room {
  glm::vec3 min, max;
  float wall_m = 0.3f;
  int32_t left = kNone, right = kNone;     // at min.x, max.x
  int32_t floor = kNone, ceiling = kNone;  // at min.y, max.y
  int32_t back = kNone, front = kNone;     // at min.z, max.z
  float floor_texture_m = 2.0f, wall_texture_m = 2.0f;
};

// Each side as a slab of its own mesh; floor and ceiling reach over the walls, back and front over
// left and right, so that no light comes in at the edges.
void add_room(Scene& scene, const Room& room, const Tessellation& tessellation);

// A skirting board along the walls that are not kNone (left, right, back, front).
struct Skirting {
  int32_t material;
  float height_m = 0.14f;
  float depth_m = 0.025f;
};
void add_skirting(Scene& scene, const Room& room, const Skirting& skirting);

// A can that throws a spot of light from `from` towards `to`: a case behind a glowing lens.
struct SpotLamp {
  std::string name;
  glm::vec3 from, to;
  glm::vec3 color{1.0f};
  float intensity_cd = 10'000.0f;
  float outer_cone_rad = 0.5f;
  float inner_cone_rad = 0.4f;
  int32_t case_material = kNone;
};
// Returns the lamp's node.
int32_t add_spot_lamp(Scene& scene, const SpotLamp& lamp);

// A slab with openings in it: `holes` are boxes that reach through it. Made of blocks side by side.
struct Box {
  glm::vec3 min, max;
};
void add_pierced_slab(MeshBuilder& builder, const Box& slab, const std::vector<Box>& holes,
                      const Tessellation& tessellation);

// A box whose edges and corners are rounded by `bevel_m`.
void add_rounded_box(MeshBuilder& builder, glm::vec3 min, glm::vec3 max, float bevel_m,
                     const Tessellation& tessellation);

}  // namespace lueur::builtin
