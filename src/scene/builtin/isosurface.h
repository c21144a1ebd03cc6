// SPDX-License-Identifier: MIT
// Meshes the zero surface of a signed distance function (negative inside): closed, every edge once
// in each direction, counter-clockwise as seen from outside, normals from the field's gradient.
// One vertex lies in each lattice cell for each piece of surface in it, so triangles are nearly
// equal in size and edges sharper than a cell come out rounded.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

struct Isosurface {
  // Never changes by more than `steepness` metres a metre: whole blocks of the lattice are then
  // left out by one look at their centre. A field that breaks this promise gives holes in the
  // shape, never in the mesh.
  std::function<float(glm::vec3 position)> distance;
  float steepness = 1.0f;

  // Encloses the surface, which must not touch it.
  glm::vec3 min{-1.0f};
  glm::vec3 max{1.0f};
};

// Adds the surface on a lattice of cells `cell_m` wide. Texture coordinates are those of a flat
// face, along the axis that the surface faces most; where that changes vertices are doubled.
// Not for a builder that only counts.
void add_isosurface(MeshBuilder& builder, const Isosurface& surface, float cell_m);

// The same with the cell width that gives `triangles` within 3 %. In practice within 1 %, as the
// number falls smoothly with the square of the cell's width.
void add_isosurface_of(MeshBuilder& builder, const Isosurface& surface, uint32_t triangles);

}  // namespace lueur::builtin
