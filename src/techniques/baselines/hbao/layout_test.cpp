// SPDX-License-Identifier: MIT
// Structures lie as the shaders read them.
#include "support/layout.h"

#include "techniques/baselines/hbao/params.h"
#include "techniques/baselines/hbao/shaders.h"

namespace lueur {
namespace {

TEST(HbaoLayout, StructuresLieAsTheShadersReadThem) {
  expect_layout(shaders::techniques_baselines_hbao_gather_comp, "push", sizeof(HbaoParams),
                {LUEUR_MEMBER(HbaoParams, screen), LUEUR_MEMBER(HbaoParams, extent),
                 LUEUR_MEMBER(HbaoParams, slices), LUEUR_MEMBER(HbaoParams, samples),
                 LUEUR_MEMBER(HbaoParams, seed), LUEUR_MEMBER(HbaoParams, radius_m),
                 LUEUR_MEMBER(HbaoParams, falloff)});
}

}  // namespace
}  // namespace lueur
