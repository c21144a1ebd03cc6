// SPDX-License-Identifier: MIT
#include "gpu/barrier.h"

namespace lueur::gpu {

UseInfo info(Use use) {
  constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  constexpr VkPipelineStageFlags2 kGraphics =
      VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  switch (use) {
    case Use::compute_sampled:
      return {kCompute, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
              VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
    case Use::compute_storage_read:
      return {kCompute, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_IMAGE_LAYOUT_GENERAL, false};
    case Use::compute_storage_write:
      return {kCompute, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
              VK_IMAGE_LAYOUT_GENERAL, true};
    case Use::dispatch_arguments:
      return {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT,
              VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Use::graphics_sampled:
      return {kGraphics, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
              VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
    case Use::graphics_buffer_read:
      return {kGraphics, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_IMAGE_LAYOUT_UNDEFINED, false};
    case Use::color_attachment:
      return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true};
    case Use::depth_attachment:
      return {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT |
                  VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                  VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, true};
    case Use::copy_source:
      return {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false};
    case Use::copy_target:
      return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true};
    case Use::host_read:
      return {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT, VK_IMAGE_LAYOUT_GENERAL,
              false};
  }
  return {};
}

std::optional<Transition> advance(AccessState& state, const UseInfo& use, bool is_image,
                                  bool discard) {
  const VkImageLayout layout =
      is_image && use.layout != VK_IMAGE_LAYOUT_UNDEFINED ? use.layout : state.layout;
  const bool changes_layout = is_image && state.layout != layout;

  // A read that the last write is already visible to needs nothing.
  if (!use.writes && !changes_layout) {
    const bool stage_waited = (state.read_stages & use.stage) == use.stage;
    const bool visible = (state.visible_access & use.access) == use.access;
    if (state.write_stage == VK_PIPELINE_STAGE_2_NONE || (stage_waited && visible)) {
      state.read_stages |= use.stage;
      state.visible_access |= use.access;
      return std::nullopt;
    }
  }

  Transition transition{};
  transition.old_layout = discard ? VK_IMAGE_LAYOUT_UNDEFINED : state.layout;
  transition.new_layout = layout;
  transition.target_stage = use.stage;
  transition.target_access = use.access;
  const bool after_write = state.write_stage != VK_PIPELINE_STAGE_2_NONE;
  transition.source_stage = state.write_stage;
  transition.source_access = state.write_access;
  // A write, and a layout change, also wait for the reads: their content must not change under
  // them.
  if (use.writes || changes_layout) transition.source_stage |= state.read_stages;

  const bool first_touch = !after_write && state.read_stages == VK_PIPELINE_STAGE_2_NONE;
  state.layout = layout;
  if (use.writes || changes_layout) {
    // A layout change writes too; what comes later has to wait for this use's stage.
    state.write_stage = use.stage;
    state.write_access = use.writes ? use.access : VK_ACCESS_2_NONE;
    state.read_stages = use.writes ? VK_PIPELINE_STAGE_2_NONE : use.stage;
    state.visible_access = use.writes ? VK_ACCESS_2_NONE : use.access;
  } else {
    state.read_stages |= use.stage;
    state.visible_access |= use.access;
  }
  if (first_touch && !changes_layout) return std::nullopt;
  return transition;
}

}  // namespace lueur::gpu
