// SPDX-License-Identifier: MIT
// The detailed object of the scenes that want one: a winged dragon coiled to rest, its head raised.
// One solid, sculpted from distances; it lies on the floor y = 0, looks along +z, and is about 1 m
// high, deep and wide.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "scene/builtin/isosurface.h"
#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

Isosurface dragon_surface();

// Adds it in `triangles` triangles, within 3 %.
void add_dragon(MeshBuilder& builder, uint32_t triangles);

// Its parts, as distances: the head in a frame of its own (x to its left, y up, z forward, origin
// between the eyes), the wings in the dragon's.
float dragon_head(glm::vec3 p);
float dragon_wings(glm::vec3 p);

}  // namespace lueur::builtin
