// SPDX-License-Identifier: MIT
// Structures shared by C++ and GLSL have one layout in both.
#include "support/layout.h"

#include <gtest/gtest.h>

#include "frame/scan_params.h"
#include "frame/shaders.h"
#include "techniques/hierarchical/params.h"
#include "techniques/hierarchical/shaders.h"
#include "techniques/joint_filter.h"
#include "techniques/shaders.h"

namespace lueur {
namespace {

TEST(Layout, StructuresAgreeWithTheShaders) {
  namespace s = shaders;
  expect_layout(s::techniques_hierarchical_prepare_comp, "params", sizeof(PrepareParams),
                {LUEUR_MEMBER(PrepareParams, screen), LUEUR_MEMBER(PrepareParams, view_from_world),
                 LUEUR_MEMBER(PrepareParams, full_extent), LUEUR_MEMBER(PrepareParams, extent)});
  expect_layout(
      s::techniques_hierarchical_downsample_comp, "push", sizeof(DownsampleParams),
      {LUEUR_MEMBER(DownsampleParams, screen), LUEUR_MEMBER(DownsampleParams, fine_scale),
       LUEUR_MEMBER(DownsampleParams, fine_extent), LUEUR_MEMBER(DownsampleParams, extent)});
  expect_layout(s::techniques_hierarchical_downsample_source_comp, "push",
                sizeof(DownsampleSourceParams),
                {LUEUR_MEMBER(DownsampleSourceParams, fine_extent),
                 LUEUR_MEMBER(DownsampleSourceParams, extent)});
  expect_layout(s::techniques_hierarchical_lobe_comp, "push", sizeof(LobeParams),
                {LUEUR_MEMBER(LobeParams, screen), LUEUR_MEMBER(LobeParams, full_extent),
                 LUEUR_MEMBER(LobeParams, extent)});
  expect_layout(s::techniques_hierarchical_albedo_comp, "push", sizeof(AlbedoParams),
                {LUEUR_MEMBER(AlbedoParams, full_extent), LUEUR_MEMBER(AlbedoParams, extent)});
  expect_layout(s::techniques_hierarchical_reflect_comp, "push", sizeof(ReflectParams),
                {LUEUR_MEMBER(ReflectParams, extent), LUEUR_MEMBER(ReflectParams, own_weight)});
  expect_layout(s::techniques_hierarchical_add_comp, "push", sizeof(AddParams),
                {LUEUR_MEMBER(AddParams, extent)});
  expect_layout(s::techniques_joint_filter_comp, "push", sizeof(FilterParams),
                {LUEUR_MEMBER(FilterParams, screen), LUEUR_MEMBER(FilterParams, extent),
                 LUEUR_MEMBER(FilterParams, step_px)});
  expect_layout(s::techniques_hierarchical_combine_comp, "push", sizeof(UpsampleParams),
                {LUEUR_MEMBER(UpsampleParams, screen), LUEUR_MEMBER(UpsampleParams, coarse_scale),
                 LUEUR_MEMBER(UpsampleParams, extent), LUEUR_MEMBER(UpsampleParams, coarse_extent),
                 LUEUR_MEMBER(UpsampleParams, own_weight)});
  expect_layout(
      s::techniques_hierarchical_warp_comp, "params", sizeof(WarpParams),
      {LUEUR_MEMBER(WarpParams, screen), LUEUR_MEMBER(WarpParams, previous),
       LUEUR_MEMBER(WarpParams, previous_view_from_view), LUEUR_MEMBER(WarpParams, full_extent),
       LUEUR_MEMBER(WarpParams, extent), LUEUR_MEMBER(WarpParams, most)});
  expect_layout(
      s::techniques_hierarchical_warp_view_comp, "params", sizeof(WarpViewParams),
      {LUEUR_MEMBER(WarpViewParams, screen), LUEUR_MEMBER(WarpViewParams, screen_there),
       LUEUR_MEMBER(WarpViewParams, there_from_here), LUEUR_MEMBER(WarpViewParams, extent)});
  expect_layout(s::techniques_hierarchical_temporal_comp, "push", sizeof(TemporalParams),
                {LUEUR_MEMBER(TemporalParams, extent), LUEUR_MEMBER(TemporalParams, has_light),
                 LUEUR_MEMBER(TemporalParams, has_history)});
  expect_layout(
      s::techniques_hierarchical_gather_view_comp, "params", sizeof(GatherViewParams),
      {LUEUR_MEMBER(GatherViewParams, gather), LUEUR_MEMBER(GatherViewParams, receiver_screen),
       LUEUR_MEMBER(GatherViewParams, source_from_receiver),
       LUEUR_MEMBER(GatherViewParams, is_first)});
  expect_layout(
      s::techniques_hierarchical_output_comp, "params", sizeof(OutputParams),
      {LUEUR_MEMBER(OutputParams, screen), LUEUR_MEMBER(OutputParams, view_from_world),
       LUEUR_MEMBER(OutputParams, coarse_scale), LUEUR_MEMBER(OutputParams, extent),
       LUEUR_MEMBER(OutputParams, coarse_extent), LUEUR_MEMBER(OutputParams, alpha_scale)});
  for (const gpu::ShaderCode* code :
       {&s::techniques_hierarchical_gather_comp, &s::techniques_hierarchical_gather_all_comp,
        &s::techniques_hierarchical_gather_visible_comp,
        &s::techniques_hierarchical_gather_glossy_comp,
        &s::techniques_hierarchical_gather_glossy_visible_comp})
    expect_layout(
        *code, "push", sizeof(GatherParams),
        {LUEUR_MEMBER(GatherParams, screen), LUEUR_MEMBER(GatherParams, extent),
         LUEUR_MEMBER(GatherParams, source_extent), LUEUR_MEMBER(GatherParams, inner_px),
         LUEUR_MEMBER(GatherParams, outer_px), LUEUR_MEMBER(GatherParams, area_over_pi),
         LUEUR_MEMBER(GatherParams, samples), LUEUR_MEMBER(GatherParams, level),
         LUEUR_MEMBER(GatherParams, seed), LUEUR_MEMBER(GatherParams, rotate),
         LUEUR_MEMBER(GatherParams, march_steps), LUEUR_MEMBER(GatherParams, march_scale)});
  expect_layout(s::frame_scan_comp, "push", sizeof(ScanParams),
                {LUEUR_MEMBER(ScanParams, extent), LUEUR_MEMBER(ScanParams, row),
                 LUEUR_MEMBER(ScanParams, allow_negative)});
  expect_layout(
      s::frame_scan_comp, "rows", sizeof(ScanRow),
      {LUEUR_MEMBER(ScanRow, nan_pixels), LUEUR_MEMBER(ScanRow, infinite_pixels),
       LUEUR_MEMBER(ScanRow, negative_pixels), LUEUR_MEMBER(ScanRow, inverted_first_pixel)});
  expect_layout(
      s::techniques_hierarchical_off_screen_comp, "push", sizeof(OffScreenParams),
      {LUEUR_MEMBER(OffScreenParams, screen), LUEUR_MEMBER(OffScreenParams, picture_screen),
       LUEUR_MEMBER(OffScreenParams, extent), LUEUR_MEMBER(OffScreenParams, picture_extent),
       LUEUR_MEMBER(OffScreenParams, texels)});
}

}  // namespace
}  // namespace lueur
