// SPDX-License-Identifier: MIT
// Walls, floors, arcades and roofs of the atrium.
#include <glm/glm.hpp>

#include "scene/builtin/arcade.h"
#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

constexpr float kCourtEdge = 3.5f;   // z of the arcades' fronts
constexpr float kArcadeBack = 4.0f;  // z of their backs
constexpr float kAisleEnd = 6.75f;   // z of the back walls' fronts
constexpr float kWallEnd = 7.1f;     // z of their backs
constexpr float kShellEnd = 7.4f;    // z of the outer shell
constexpr float kLowerTop = 4.8f;    // underside of the gallery floor
constexpr float kUpperTop = 9.3f;    // underside of the roofs
constexpr float kRoofTop = 9.6f;
constexpr float kEndWall = 0.35f;     // thickness of an end wall
constexpr float kEndShell = 0.35f;    // and of the shell behind it
constexpr float kArchRadius = 1.35f;  // leaves a capital's width between two arches
constexpr float kUpperArchRadius = 1.42f;
constexpr float kLowerSpringing = kStep + kColumnHeight;
constexpr float kUpperSpringing = kGalleryFloor + kPedestalHeight + kUpperColumnHeight;

// The turn that brings a piece made for the side at -z to that side (0) or the other (1).
glm::mat4 long_side(int side) {
  const float s = side == 0 ? 1.0f : -1.0f;
  return {{s, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, s, 0}, {0, 0, 0, 1}};
}

// The turn that brings a wall along x that faces +z to the end at -x (0) or +x (1): z becomes ±x.
glm::mat4 short_side(int side) {
  const float s = side == 0 ? 1.0f : -1.0f;
  return {{0, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, 0, 0}, {0, 0, 0, 1}};
}

// A cornice `height` tall that steps out to `depth` in two curves.
Profile cornice(float depth, float height, const Tessellation& tessellation) {
  Profile profile({-0.05f, 0}, tessellation);
  profile.line_to({0.15f * depth, 0})
      .line_to({0.15f * depth, 0.2f * height})
      .arc_to({0.6f * depth, 0.55f * height}, -1.3f, 2)
      .line_to({0.75f * depth, 0.6f * height})
      .arc_to({depth, 0.85f * height}, 1.3f, 1)
      .line_to({depth, height})
      .line_to({-0.05f, height})
      .line_to({-0.05f, 0});
  return profile;
}
constexpr float kCapHeight = 0.7f;  // of the height of a cornice: a point that sees its outline

void add_cornice(MeshBuilder& builder, float depth, float y0, float height, float half_length,
                 float z, const Tessellation& tessellation) {
  add_moulding(builder, cornice(depth, height, tessellation), {0.02f, kCapHeight * height},
               {-half_length, y0, z}, {half_length, y0, z}, {0, 0, 1}, tessellation);
}

ArcadeWall storey_arcade(float springing, float top, float radius) {
  ArcadeWall wall{-kHalfLength - 0.05f, kHalfLength + 0.05f, springing, springing, top,
                  -kArcadeBack,         -kCourtEdge,         {}};
  for (int bay = 0; bay < kBays; ++bay) wall.openings.push_back({bay_center(bay), radius});
  return wall;
}

// The wall between two pedestals of the gallery, with a hand rail on it.
void add_parapet(MeshBuilder& builder, const Tessellation& tessellation) {
  const float y0 = kGalleryFloor - 0.02f, y1 = kGalleryFloor + kPedestalHeight;
  for (int line = 0; line <= kBays; ++line) {
    const float x = column_line(line);
    add_box(builder, {x - 0.3f, y0, -kColumnZ - 0.25f}, {x + 0.3f, y1, -kColumnZ + 0.25f},
            tessellation, kNegativeY);
  }
  for (int bay = 0; bay < kBays; ++bay) {
    const float x0 = column_line(bay) + 0.29f, x1 = column_line(bay + 1) - 0.29f;
    add_box(builder, {x0, y0, -kColumnZ - 0.1f}, {x1, y1 - 0.1f, -kColumnZ + 0.1f}, tessellation,
            kNegativeX | kPositiveX | kNegativeY | kPositiveY);
    add_box(builder, {x0, y1 - 0.12f, -kColumnZ - 0.18f}, {x1, y1 - 0.02f, -kColumnZ + 0.18f},
            tessellation, kNegativeX | kPositiveX);
  }
}

ArcadeWall back_wall(float bottom, float springing, float top, float radius) {
  ArcadeWall wall{
      -kHalfLength - 0.05f, kHalfLength + 0.05f, bottom, springing, top, -kWallEnd, -kAisleEnd, {}};
  for (int bay = 0; bay < kBays; bay += 2) wall.openings.push_back({bay_center(bay), radius});
  return wall;
}

// A door leaf in every other opening; its upper corners vanish in the wall.
void add_doors(MeshBuilder& builder, const ArcadeWall& wall, const Tessellation& tessellation) {
  for (size_t k = 0; k < wall.openings.size(); ++k) {
    if (k % 2 == 0 && wall.openings.size() > 1) continue;
    const ArchOpening& arch = wall.openings[k];
    const float half = arch.radius_m + 0.02f;
    add_box(builder, {arch.center_x - half, wall.bottom, wall.z0 + 0.02f},
            {arch.center_x + half, wall.springing + arch.radius_m + 0.02f, wall.z0 + 0.12f},
            tessellation, kNegativeX | kPositiveX | kNegativeY | kPositiveY | kNegativeZ);
  }
}

constexpr unsigned kAllButFront = kNegativeX | kPositiveX | kNegativeY | kPositiveY | kNegativeZ;

}  // namespace

void add_court_floor(MeshBuilder& builder, const AtriumMaterials& materials,
                     const Tessellation& tessellation) {
  const float x = kHalfLength + kEndWall + kEndShell;
  builder.set_material(materials.pavement, 2.0f);
  add_box(builder, {-x, -0.4f, -kShellEnd}, {x, 0, kShellEnd}, tessellation,
          kNegativeX | kPositiveX | kNegativeY | kNegativeZ | kPositiveZ);
}

void add_aisles(MeshBuilder& builder, const AtriumMaterials& materials,
                const Tessellation& tessellation) {
  const float x = kHalfLength + 0.1f;
  for (int side = 0; side < 2; ++side) {
    builder.set_transform(long_side(side));

    // The step under the lower aisle and the gallery's floor.
    builder.set_material(materials.pavement, 2.0f);
    add_box(builder, {-x, -0.1f, -kAisleEnd - 0.1f}, {x, kStep, -kCourtEdge + 0.2f}, tessellation,
            kNegativeX | kPositiveX | kNegativeY | kNegativeZ);
    builder.set_material(materials.plaster, 2.0f);
    add_box(builder, {-x, kLowerTop, -kAisleEnd - 0.1f}, {x, kGalleryFloor, -kCourtEdge},
            tessellation, kNegativeX | kPositiveX | kNegativeZ);

    // Beams that carry both ceilings, from each column to the back wall.
    builder.set_material(materials.wood, 0.6f);
    for (int line = 1; line < kBays; ++line) {
      const float c = column_line(line);
      for (const float top : {kLowerTop, kUpperTop})
        add_box(builder, {c - 0.13f, top - 0.3f, -kAisleEnd - 0.05f},
                {c + 0.13f, top + 0.02f, -kArcadeBack + 0.05f}, tessellation,
                kNegativeZ | kPositiveZ | kPositiveY);
    }
  }
  builder.set_transform(glm::mat4(1.0f));
}

void add_arcades(MeshBuilder& builder, const AtriumMaterials& materials,
                 const Tessellation& tessellation) {
  for (int side = 0; side < 2; ++side) {
    builder.set_transform(long_side(side));
    const ArcadeWall lower = storey_arcade(kLowerSpringing, kLowerTop, kArchRadius);
    const ArcadeWall upper = storey_arcade(kUpperSpringing, kUpperTop, kUpperArchRadius);
    builder.set_material(materials.masonry, 2.0f);
    add_arcade_wall(builder, lower, tessellation);
    add_arcade_wall(builder, upper, tessellation);

    builder.set_material(materials.limestone, 2.0f);
    add_archivolts(builder, lower, tessellation);
    add_archivolts(builder, upper, tessellation);
    add_cornice(builder, 0.22f, kLowerTop - 0.02f, 0.37f, kHalfLength + 0.04f, -kCourtEdge,
                tessellation);
    add_cornice(builder, 0.3f, kUpperTop - 0.32f, 0.34f, kHalfLength + 0.04f, -kCourtEdge,
                tessellation);
    add_parapet(builder, tessellation);

    // Half piers carry the last arches at the end walls.
    for (const float x : {-kHalfLength, kHalfLength}) {
      const float x0 = x < 0 ? x - 0.04f : x - 0.35f, x1 = x < 0 ? x + 0.35f : x + 0.04f;
      add_box(builder, {x0, kStep - 0.05f, -kArcadeBack + 0.01f},
              {x1, kLowerSpringing, -kCourtEdge - 0.01f}, tessellation, kNegativeY | kPositiveY);
      add_box(builder, {x0, kGalleryFloor - 0.05f, -kArcadeBack + 0.01f},
              {x1, kUpperSpringing, -kCourtEdge - 0.01f}, tessellation, kNegativeY | kPositiveY);
    }
  }
  builder.set_transform(glm::mat4(1.0f));
}

void add_back_walls(MeshBuilder& builder, const AtriumMaterials& materials,
                    const Tessellation& tessellation) {
  const float x = kHalfLength + kEndWall + kEndShell;
  for (int side = 0; side < 2; ++side) {
    builder.set_transform(long_side(side));
    const ArcadeWall lower = back_wall(0.02f, kStep + 2.0f, kLowerTop + 0.02f, 0.6f);
    const ArcadeWall upper =
        back_wall(kGalleryFloor - 0.1f, kGalleryFloor + 2.0f, kUpperTop + 0.02f, 0.55f);
    builder.set_material(materials.plaster, 3.0f);
    add_arcade_wall(builder, lower, tessellation);
    add_arcade_wall(builder, upper, tessellation);
    builder.set_material(materials.limestone, 2.0f);
    add_archivolts(builder, lower, tessellation);
    add_archivolts(builder, upper, tessellation);
    builder.set_material(materials.wood, 1.0f);
    add_doors(builder, lower, tessellation);
    add_doors(builder, upper, tessellation);

    // The shell closes the niches and keeps the sun out.
    builder.set_material(materials.masonry, 2.0f);
    add_box(builder, {-x, -0.1f, -kShellEnd}, {x, kRoofTop - 0.02f, -kWallEnd + 0.02f},
            tessellation, kAllButFront);
  }
  builder.set_transform(glm::mat4(1.0f));
}

void add_end_walls(MeshBuilder& builder, const AtriumMaterials& materials,
                   const Tessellation& tessellation) {
  const float z = -kHalfLength, half = kAisleEnd + 0.1f;
  for (int side = 0; side < 2; ++side) {
    builder.set_transform(short_side(side));
    const ArcadeWall lower{-half,
                           half,
                           0.02f - 0.1f,
                           kStep + 2.3f,
                           kGalleryFloor - 0.1f,
                           z - kEndWall,
                           z,
                           {{-5.4f, 0.6f}, {0, 1.0f}, {5.4f, 0.6f}}};
    const ArcadeWall upper{-half,
                           half,
                           kGalleryFloor - 0.1f,
                           kGalleryFloor + 2.2f,
                           kUpperTop + 0.1f,
                           z - kEndWall,
                           z,
                           {{-5.4f, 0.55f}, {0, 1.0f}, {5.4f, 0.55f}}};
    builder.set_material(materials.masonry, 2.0f);
    add_arcade_wall(builder, lower, tessellation);
    add_arcade_wall(builder, upper, tessellation);
    builder.set_material(materials.limestone, 2.0f);
    add_archivolts(builder, lower, tessellation);
    add_archivolts(builder, upper, tessellation);
    add_cornice(builder, 0.22f, kLowerTop - 0.02f, 0.37f, kCourtEdge - 0.02f, z, tessellation);
    add_cornice(builder, 0.3f, kUpperTop - 0.32f, 0.34f, kCourtEdge - 0.02f, z, tessellation);
    builder.set_material(materials.wood, 1.0f);
    ArcadeWall portal = lower;
    portal.openings = {{0, 1.0f}};
    add_doors(builder, portal, tessellation);
    builder.set_material(materials.plaster, 3.0f);
    add_box(builder, {-kWallEnd, -0.1f, z - kEndWall - kEndShell},
            {kWallEnd, kRoofTop - 0.02f, z - kEndWall + 0.02f}, tessellation, kAllButFront);
  }
  builder.set_transform(glm::mat4(1.0f));
}

void add_roofs(MeshBuilder& builder, const AtriumMaterials& materials,
               const Tessellation& tessellation) {
  const float x = kHalfLength + kEndWall + kEndShell + 0.1f;
  for (int side = 0; side < 2; ++side) {
    builder.set_transform(long_side(side));
    builder.set_material(materials.terracotta, 2.0f);
    add_box(builder, {-x, kUpperTop, -kShellEnd - 0.1f}, {x, kRoofTop, -kCourtEdge + 0.32f},
            tessellation, kNegativeX | kPositiveX | kNegativeZ);
    builder.set_transform(short_side(side));
    add_box(builder, {-kCourtEdge + 0.3f, kUpperTop + 0.01f, -x},
            {kCourtEdge - 0.3f, kRoofTop - 0.01f, -kHalfLength + 0.32f}, tessellation,
            kNegativeX | kPositiveX | kNegativeZ);
  }
  builder.set_transform(glm::mat4(1.0f));
}

}  // namespace lueur::builtin
