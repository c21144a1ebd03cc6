// SPDX-License-Identifier: MIT
// Structures lie as the shaders read them.
#include "support/layout.h"

#include "cube_maps/equations.h"
#include "cube_maps/params.h"
#include "cube_maps/shaders.h"

namespace lueur {
namespace {

TEST(CubeMapsLayout, StructuresLieAsTheShadersReadThem) {
  expect_layout(shaders::cube_maps_texels_comp, "push", sizeof(TexelsParams),
                {LUEUR_MEMBER(TexelsParams, screen), LUEUR_MEMBER(TexelsParams, corner),
                 LUEUR_MEMBER(TexelsParams, factor), LUEUR_MEMBER(TexelsParams, far_m),
                 LUEUR_MEMBER(TexelsParams, has_background)});
  expect_layout(shaders::cube_maps_place_comp, "push", sizeof(PlaceParams),
                {LUEUR_MEMBER(PlaceParams, screen), LUEUR_MEMBER(PlaceParams, side),
                 LUEUR_MEMBER(PlaceParams, map), LUEUR_MEMBER(PlaceParams, texels)});
  expect_layout(shaders::cube_maps_place_comp, "texels", sizeof(TexelLight),
                {LUEUR_MEMBER(TexelLight, position), LUEUR_MEMBER(TexelLight, gain),
                 LUEUR_MEMBER(TexelLight, radiance), LUEUR_MEMBER(TexelLight, shrink)});
}

}  // namespace
}  // namespace lueur
