// SPDX-License-Identifier: MIT
// Structures lie as the shaders read them.
#include "support/layout.h"

#include "techniques/baselines/params.h"
#include "techniques/baselines/shaders.h"

namespace lueur {
namespace {

TEST(SlicesLayout, StructuresLieAsTheShadersReadThem) {
  expect_layout(shaders::techniques_baselines_geometry_comp, "push", sizeof(GeometryParams),
                {LUEUR_MEMBER(GeometryParams, camera)});
  expect_layout(shaders::techniques_baselines_occlusion_comp, "push", sizeof(OcclusionParams),
                {LUEUR_MEMBER(OcclusionParams, extent)});
}

}  // namespace
}  // namespace lueur
