// SPDX-License-Identifier: MIT
// Structures lie as the shaders read them.
#include "support/layout.h"

#include "techniques/indirect_lights/params.h"
#include "techniques/indirect_lights/shaders.h"

namespace lueur {
namespace {

TEST(IndirectLightsLayout, StructuresLieAsTheShadersReadThem) {
  expect_layout(shaders::techniques_indirect_lights_place_comp, "lights", sizeof(IndirectLight),
                {LUEUR_MEMBER(IndirectLight, position), LUEUR_MEMBER(IndirectLight, area_over_pi),
                 LUEUR_MEMBER(IndirectLight, normal_area), LUEUR_MEMBER(IndirectLight, radiance)});
  expect_layout(shaders::techniques_indirect_lights_place_comp, "rays", sizeof(PlacedRay),
                {LUEUR_MEMBER(PlacedRay, at_px), LUEUR_MEMBER(PlacedRay, solid_angle_sr),
                 LUEUR_MEMBER(PlacedRay, slot)});
  expect_layout(shaders::techniques_indirect_lights_place_comp, "params", sizeof(PlaceParams),
                {LUEUR_MEMBER(PlaceParams, screen), LUEUR_MEMBER(PlaceParams, camera_from_view),
                 LUEUR_MEMBER(PlaceParams, camera_from_world),
                 LUEUR_MEMBER(PlaceParams, view_from_world), LUEUR_MEMBER(PlaceParams, rays)});
  expect_layout(shaders::techniques_indirect_lights_negative_comp, "params", sizeof(NegativeParams),
                {LUEUR_MEMBER(NegativeParams, camera), LUEUR_MEMBER(NegativeParams, lights),
                 LUEUR_MEMBER(NegativeParams, negative)});
  expect_layout(shaders::techniques_indirect_lights_gather_comp, "params", sizeof(GatherParams),
                {LUEUR_MEMBER(GatherParams, camera), LUEUR_MEMBER(GatherParams, extent),
                 LUEUR_MEMBER(GatherParams, factor), LUEUR_MEMBER(GatherParams, lights)});
  expect_layout(
      shaders::techniques_indirect_lights_interpolate_comp, "params", sizeof(InterpolateParams),
      {LUEUR_MEMBER(InterpolateParams, camera), LUEUR_MEMBER(InterpolateParams, low_extent),
       LUEUR_MEMBER(InterpolateParams, factor), LUEUR_MEMBER(InterpolateParams, discontinuity)});
  expect_layout(shaders::techniques_indirect_lights_refine_comp, "params", sizeof(RefineParams),
                {LUEUR_MEMBER(RefineParams, camera), LUEUR_MEMBER(RefineParams, lights)});
}

}  // namespace
}  // namespace lueur
