// SPDX-License-Identifier: MIT
// Structures lie as the shaders read them.
#include "support/layout.h"

#include "cube_maps/params.h"
#include "techniques/cube_map/params.h"
#include "techniques/cube_map/shaders.h"

namespace lueur {
namespace {

TEST(CubeMapLayout, StructuresLieAsTheShadersReadThem) {
  namespace s = shaders;
  expect_layout(s::techniques_cube_map_begin_comp, "push", sizeof(BeginParams),
                {LUEUR_MEMBER(BeginParams, extent)});
  expect_layout(s::techniques_cube_map_convolve_comp, "push", sizeof(PlaceParams),
                {LUEUR_MEMBER(PlaceParams, screen), LUEUR_MEMBER(PlaceParams, side),
                 LUEUR_MEMBER(PlaceParams, map), LUEUR_MEMBER(PlaceParams, texels)});
  for (const auto* gather :
       {&s::techniques_cube_map_gather_comp, &s::techniques_cube_map_gather_glossy_comp,
        &s::techniques_cube_map_look_up_comp})
    expect_layout(*gather, "params", sizeof(GatherParams),
                  {LUEUR_MEMBER(GatherParams, camera), LUEUR_MEMBER(GatherParams, share),
                   LUEUR_MEMBER(GatherParams, first), LUEUR_MEMBER(GatherParams, end),
                   LUEUR_MEMBER(GatherParams, first_texel), LUEUR_MEMBER(GatherParams, end_texel),
                   LUEUR_MEMBER(GatherParams, blinn_exponent)});
  expect_layout(s::techniques_cube_map_finish_comp, "push", sizeof(FinishParams),
                {LUEUR_MEMBER(FinishParams, extent)});
}

}  // namespace
}  // namespace lueur
