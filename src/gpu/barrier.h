// SPDX-License-Identifier: MIT
// Which barrier a use of a resource needs after the uses before it. Pure logic, tested without a
// device.
#pragma once

#include <optional>

#include "gpu/vulkan.h"

namespace lueur::gpu {

// How a pass uses a resource.
enum class Use : uint8_t {
  compute_sampled,        // sampler in a compute shader
  compute_storage_read,   // readonly image or buffer in a compute shader
  compute_storage_write,  // image or buffer that a compute shader writes, and may read
  dispatch_arguments,     // buffer with the numbers of workgroups
  graphics_sampled,       // sampler in a vertex or fragment shader
  graphics_buffer_read,   // readonly buffer in a vertex or fragment shader
  color_attachment,
  depth_attachment,
  copy_source,
  copy_target,
  host_read,
};

struct UseInfo {
  VkPipelineStageFlags2 stage;
  VkAccessFlags2 access;
  VkImageLayout layout;  // of images
  bool writes;
};
UseInfo info(Use use);

// What has happened to a resource since its content was last written.
struct AccessState {
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkPipelineStageFlags2 write_stage = VK_PIPELINE_STAGE_2_NONE;
  VkAccessFlags2 write_access = VK_ACCESS_2_NONE;
  VkPipelineStageFlags2 read_stages = VK_PIPELINE_STAGE_2_NONE;  // that read since the write
  VkAccessFlags2 visible_access = VK_ACCESS_2_NONE;  // read accesses the write is visible to
};

struct Transition {
  VkPipelineStageFlags2 source_stage;
  VkAccessFlags2 source_access;
  VkPipelineStageFlags2 target_stage;
  VkAccessFlags2 target_access;
  VkImageLayout old_layout;
  VkImageLayout new_layout;
};

// Brings `state` to what it is after `use`, and returns the barrier needed before it, if any.
// `discard`: the old content is not wanted. `is_image`: layouts matter.
std::optional<Transition> advance(AccessState& state, const UseInfo& use, bool is_image,
                                  bool discard);

}  // namespace lueur::gpu
