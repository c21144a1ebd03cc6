// SPDX-License-Identifier: MIT
// Structures lie as the shaders read them.
#include "support/layout.h"

#include "techniques/baselines/visibility_bitmask/params.h"
#include "techniques/baselines/visibility_bitmask/shaders.h"

namespace lueur {
namespace {

TEST(VisibilityBitmaskLayout, StructuresLieAsTheShadersReadThem) {
  expect_layout(
      shaders::techniques_baselines_visibility_bitmask_gather_comp, "push", sizeof(BitmaskParams),
      {LUEUR_MEMBER(BitmaskParams, screen), LUEUR_MEMBER(BitmaskParams, extent),
       LUEUR_MEMBER(BitmaskParams, slices), LUEUR_MEMBER(BitmaskParams, samples),
       LUEUR_MEMBER(BitmaskParams, seed), LUEUR_MEMBER(BitmaskParams, radius_m),
       LUEUR_MEMBER(BitmaskParams, distance_m), LUEUR_MEMBER(BitmaskParams, thickness_m)});
}

}  // namespace
}  // namespace lueur
