// SPDX-License-Identifier: MIT
// Structures lie as the shaders read them.
#include "support/layout.h"

#include "surfels/params.h"
#include "surfels/shaders.h"

namespace lueur {
namespace {

TEST(SurfelsLayout, StructuresLieAsTheShadersReadThem) {
  for (const auto* shader : {&shaders::surfels_split_comp, &shaders::surfels_place_comp}) {
    expect_layout(
        *shader, "push", sizeof(SurfelizeParams),
        {LUEUR_MEMBER(SurfelizeParams, screen), LUEUR_MEMBER(SurfelizeParams, corner_px),
         LUEUR_MEMBER(SurfelizeParams, pixel), LUEUR_MEMBER(SurfelizeParams, radius_px),
         LUEUR_MEMBER(SurfelizeParams, margin_m), LUEUR_MEMBER(SurfelizeParams, least_distance_m),
         LUEUR_MEMBER(SurfelizeParams, first_float), LUEUR_MEMBER(SurfelizeParams, stride_floats),
         LUEUR_MEMBER(SurfelizeParams, chunks), LUEUR_MEMBER(SurfelizeParams, parts_capacity),
         LUEUR_MEMBER(SurfelizeParams, surfels_capacity)});
    expect_layout(
        *shader, "ranges", sizeof(SurfelRange),
        {LUEUR_MEMBER(SurfelRange, view_from_object), LUEUR_MEMBER(SurfelRange, first_index),
         LUEUR_MEMBER(SurfelRange, vertex_offset), LUEUR_MEMBER(SurfelRange, triangle_count)});
  }
  expect_layout(shaders::surfels_split_comp, "chunks", sizeof(SurfelChunk),
                {LUEUR_MEMBER(SurfelChunk, range), LUEUR_MEMBER(SurfelChunk, first_triangle)});
}

}  // namespace
}  // namespace lueur
