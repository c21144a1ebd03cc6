// SPDX-License-Identifier: MIT
// The pieces of the atrium. The court lies around the origin, long along x; floor at y = 0. Pieces
// that stand on both long sides are made for the side at -z, facing +z, and turned for the other.
#pragma once

#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

// Indices into the scene's materials.
struct AtriumMaterials {
  int32_t pavement, masonry, limestone, plaster, wood, terracotta, bronze, leaves, water;
  int32_t cloth[3];  // red, green, blue
};

inline constexpr int kBays = 7;
inline constexpr float kBayWidth = 3.4f;
inline constexpr float kHalfLength = 0.5f * kBayWidth * float(kBays);
inline constexpr float kColumnZ = 3.75f;  // centre line of the arcades
inline constexpr float kStep = 0.15f;     // the aisles lie a step above the court
inline constexpr float kGalleryFloor = 5.15f;
inline constexpr float kColumnHeight = 2.9f;  // lower storey, with base and capital
inline constexpr float kUpperColumnHeight = 1.4f;
inline constexpr float kPedestalHeight = 0.95f;

// Centre of bay `bay` along x, and place of the column line `line` (0 and kBays are at the ends).
inline float bay_center(int bay) {
  return kBayWidth * (float(bay) + 0.5f) - kHalfLength;
}
inline float column_line(int line) {
  return kBayWidth * float(line) - kHalfLength;
}

// The standing structure, one mesh each.
void add_court_floor(MeshBuilder& builder, const AtriumMaterials& materials,
                     const Tessellation& tessellation);
void add_aisles(MeshBuilder& builder, const AtriumMaterials& materials,
                const Tessellation& tessellation);
void add_arcades(MeshBuilder& builder, const AtriumMaterials& materials,
                 const Tessellation& tessellation);
void add_back_walls(MeshBuilder& builder, const AtriumMaterials& materials,
                    const Tessellation& tessellation);
void add_end_walls(MeshBuilder& builder, const AtriumMaterials& materials,
                   const Tessellation& tessellation);
void add_roofs(MeshBuilder& builder, const AtriumMaterials& materials,
               const Tessellation& tessellation);

// Things that stand about, around their own origin at their foot.
void add_column(MeshBuilder& builder, const AtriumMaterials& materials,
                const Tessellation& tessellation);
void add_upper_column(MeshBuilder& builder, const AtriumMaterials& materials,
                      const Tessellation& tessellation);
void add_planter(MeshBuilder& builder, const AtriumMaterials& materials,
                 const Tessellation& tessellation);
void add_fountain(MeshBuilder& builder, const AtriumMaterials& materials,
                  const Tessellation& tessellation);

// A pair of curtains on a rod between two columns, tied back; origin on the floor between them.
void add_curtains(MeshBuilder& builder, const AtriumMaterials& materials, int color,
                  const Tessellation& tessellation);
// A banner on a rod; origin in the middle of the rod, front towards +z.
void add_banner(MeshBuilder& builder, const AtriumMaterials& materials, int color,
                const Tessellation& tessellation);

}  // namespace lueur::builtin
