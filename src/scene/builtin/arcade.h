// SPDX-License-Identifier: MIT
// Walls with round-arched openings. They run along x, their front faces +z.
#pragma once

#include <vector>

#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {

struct ArchOpening {
  float center_x;
  float radius_m;
};

// From x0 to x1, bottom to top and z0 to z1. The openings (in ascending x, apart from each other
// and from the ends) are semicircles over `springing`, open below. With bottom = springing only the
// spandrels remain, to be carried by columns; otherwise piers reach down to `bottom`.
struct ArcadeWall {
  float x0, x1;
  float bottom, springing, top;
  float z0, z1;
  std::vector<ArchOpening> openings;
};

void add_arcade_wall(MeshBuilder& builder, const ArcadeWall& wall,
                     const Tessellation& tessellation);

// The raised band around each opening of `wall`, on its front; left out of coarse scenes.
void add_archivolts(MeshBuilder& builder, const ArcadeWall& wall, const Tessellation& tessellation);

}  // namespace lueur::builtin
