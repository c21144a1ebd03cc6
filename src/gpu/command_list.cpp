// SPDX-License-Identifier: MIT
#include "gpu/command_list.h"

#include "base/check.h"

namespace lueur::gpu {

void CommandList::begin_label(const std::string& text) {
  if (!labels_) return;
  VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = text.c_str();
  vkCmdBeginDebugUtilsLabelEXT(handle_, &label);
}

void CommandList::end_label() {
  if (labels_) vkCmdEndDebugUtilsLabelEXT(handle_);
}

void CommandList::barrier(std::span<const ImageTransition> images,
                          std::span<const BufferTransition> buffers) {
  if (images.empty() && buffers.empty()) return;
  std::vector<VkImageMemoryBarrier2> image_barriers;
  for (const ImageTransition& t : images) {
    VkImageMemoryBarrier2 b{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    b.srcStageMask = t.transition.source_stage;
    b.srcAccessMask = t.transition.source_access;
    b.dstStageMask = t.transition.target_stage;
    b.dstAccessMask = t.transition.target_access;
    b.oldLayout = t.transition.old_layout;
    b.newLayout = t.transition.new_layout;
    b.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    b.image = t.image;
    b.subresourceRange = {t.aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
    image_barriers.push_back(b);
  }
  std::vector<VkBufferMemoryBarrier2> buffer_barriers;
  for (const BufferTransition& t : buffers) {
    VkBufferMemoryBarrier2 b{VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
    b.srcStageMask = t.transition.source_stage;
    b.srcAccessMask = t.transition.source_access;
    b.dstStageMask = t.transition.target_stage;
    b.dstAccessMask = t.transition.target_access;
    b.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    b.buffer = t.buffer;
    b.size = VK_WHOLE_SIZE;
    buffer_barriers.push_back(b);
  }
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = static_cast<uint32_t>(image_barriers.size());
  dependency.pImageMemoryBarriers = image_barriers.data();
  dependency.bufferMemoryBarrierCount = static_cast<uint32_t>(buffer_barriers.size());
  dependency.pBufferMemoryBarriers = buffer_barriers.data();
  vkCmdPipelineBarrier2(handle_, &dependency);
}

void CommandList::full_barrier() {
  VkMemoryBarrier2 all{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  all.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  all.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  all.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  all.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &all;
  vkCmdPipelineBarrier2(handle_, &dependency);
}

void CommandList::timestamp(VkQueryPool pool, uint32_t query) {
  vkCmdWriteTimestamp2(handle_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, query);
}

void CommandList::bind(const Pipeline& pipeline, uint32_t set, VkDescriptorSet descriptors) {
  vkCmdBindDescriptorSets(handle_, pipeline.bind_point, pipeline.layout, set, 1, &descriptors, 0,
                          nullptr);
}

void CommandList::push(const Pipeline& pipeline, const void* data, uint32_t bytes) {
  vkCmdPushConstants(handle_, pipeline.layout, pipeline.stages, 0, bytes, data);
}

void CommandList::dispatch(const Pipeline& pipeline, uint32_t groups_x, uint32_t groups_y,
                           uint32_t groups_z) {
  vkCmdBindPipeline(handle_, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle);
  vkCmdDispatch(handle_, groups_x, groups_y, groups_z);
}

void CommandList::dispatch_indirect(const Pipeline& pipeline, VkBuffer groups, uint64_t offset) {
  vkCmdBindPipeline(handle_, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle);
  vkCmdDispatchIndirect(handle_, groups, offset);
}

void CommandList::begin_rendering(Extent extent, std::span<const ColorTarget> colors,
                                  const DepthTarget& depth) {
  std::vector<VkRenderingAttachmentInfo> color_attachments;
  for (const ColorTarget& target : colors) {
    VkRenderingAttachmentInfo a{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    a.imageView = target.view;
    a.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    a.loadOp = target.keep ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
    a.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    for (size_t c = 0; c < 4; ++c) a.clearValue.color.float32[c] = target.clear[c];
    color_attachments.push_back(a);
  }
  VkRenderingAttachmentInfo depth_attachment{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  depth_attachment.imageView = depth.view;
  depth_attachment.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
  depth_attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  depth_attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  depth_attachment.clearValue.depthStencil.depth = depth.clear;

  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea = {{0, 0}, {extent.width, extent.height}};
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = static_cast<uint32_t>(color_attachments.size());
  rendering.pColorAttachments = color_attachments.data();
  rendering.pDepthAttachment = depth.view ? &depth_attachment : nullptr;
  vkCmdBeginRendering(handle_, &rendering);

  const VkViewport viewport{
      0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
  vkCmdSetViewport(handle_, 0, 1, &viewport);
  vkCmdSetScissor(handle_, 0, 1, &rendering.renderArea);
}

void CommandList::bind_pipeline(const Pipeline& pipeline) {
  vkCmdBindPipeline(handle_, pipeline.bind_point, pipeline.handle);
}

void CommandList::front_face(bool counter_clockwise) {
  vkCmdSetFrontFace(handle_,
                    counter_clockwise ? VK_FRONT_FACE_COUNTER_CLOCKWISE : VK_FRONT_FACE_CLOCKWISE);
}

void CommandList::cull_back_faces(bool on) {
  vkCmdSetCullMode(handle_, on ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE);
}

void CommandList::bind_geometry(VkBuffer vertices, VkBuffer indices) {
  const VkDeviceSize offset = 0;
  vkCmdBindVertexBuffers(handle_, 0, 1, &vertices, &offset);
  vkCmdBindIndexBuffer(handle_, indices, 0, VK_INDEX_TYPE_UINT32);
}

void CommandList::draw(uint32_t vertex_count) {
  vkCmdDraw(handle_, vertex_count, 1, 0, 0);
}

void CommandList::draw_indexed(uint32_t index_count, uint32_t first_index, int32_t vertex_offset,
                               uint32_t instance_count, uint32_t first_instance) {
  vkCmdDrawIndexed(handle_, index_count, instance_count, first_index, vertex_offset,
                   first_instance);
}

void CommandList::end_rendering() {
  vkCmdEndRendering(handle_);
}

void CommandList::copy_to_buffer(VkImage image, VkImageAspectFlags aspect, VkBuffer buffer,
                                 const CopyRegion& region) {
  VkBufferImageCopy copy{};
  copy.bufferOffset = region.buffer_offset;
  copy.imageSubresource = {aspect, region.mip_level, region.layer, 1};
  copy.imageExtent = {region.extent.width, region.extent.height, 1};
  vkCmdCopyImageToBuffer(handle_, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &copy);
}

void CommandList::copy_to_image(VkBuffer buffer, VkImage image,
                                std::span<const CopyRegion> regions) {
  std::vector<VkBufferImageCopy> copies;
  for (const CopyRegion& region : regions) {
    VkBufferImageCopy copy{};
    copy.bufferOffset = region.buffer_offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, region.mip_level, region.layer, 1};
    copy.imageExtent = {region.extent.width, region.extent.height, 1};
    copies.push_back(copy);
  }
  vkCmdCopyBufferToImage(handle_, buffer, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                         static_cast<uint32_t>(copies.size()), copies.data());
}

void CommandList::copy_image(VkImage from, VkImage to, Extent extent, bool is_depth) {
  VkImageCopy copy{};
  copy.srcSubresource = {static_cast<VkImageAspectFlags>(is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                  : VK_IMAGE_ASPECT_COLOR_BIT),
                         0, 0, 1};
  copy.dstSubresource = copy.srcSubresource;
  copy.extent = {extent.width, extent.height, 1};
  vkCmdCopyImage(handle_, from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to,
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
}

void CommandList::copy_buffer(VkBuffer from, uint64_t from_offset, VkBuffer to, uint64_t to_offset,
                              uint64_t bytes) {
  const VkBufferCopy copy{from_offset, to_offset, bytes};
  vkCmdCopyBuffer(handle_, from, to, 1, &copy);
}

void CommandList::fill_buffer(VkBuffer buffer, uint32_t value) {
  vkCmdFillBuffer(handle_, buffer, 0, VK_WHOLE_SIZE, value);
}

SamplerLibrary::~SamplerLibrary() {
  for (auto& [state, sampler] : samplers_) vkDestroySampler(device_.handle, sampler, nullptr);
}

VkSampler SamplerLibrary::get(const SamplerState& state) {
  if (const auto found = samplers_.find(state); found != samplers_.end()) return found->second;
  constexpr VkSamplerAddressMode kAddress[] = {VK_SAMPLER_ADDRESS_MODE_REPEAT,
                                               VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                               VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT};
  VkSamplerCreateInfo create{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  create.magFilter = state.filter == Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  create.minFilter = create.magFilter;
  create.mipmapMode =
      state.mipmaps ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  create.addressModeU = kAddress[static_cast<size_t>(state.u)];
  create.addressModeV = kAddress[static_cast<size_t>(state.v)];
  create.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  create.maxLod = state.mipmaps ? VK_LOD_CLAMP_NONE : 0.0f;
  create.compareEnable = state.compare;
  create.compareOp = VK_COMPARE_OP_GREATER_OR_EQUAL;
  VkSampler sampler = VK_NULL_HANDLE;
  const VkResult result = vkCreateSampler(device_.handle, &create, nullptr, &sampler);
  LUEUR_CHECK_OP(result, ==, VK_SUCCESS);
  return samplers_[state] = sampler;
}

DescriptorArena::~DescriptorArena() {
  for (VkDescriptorPool pool : pools_) vkDestroyDescriptorPool(device_.handle, pool, nullptr);
}

Result<void> DescriptorArena::grow() {
  constexpr VkDescriptorPoolSize kSizes[] = {
      {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1024},
      {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 512},
      {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 512},
      {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 256},
  };
  VkDescriptorPoolCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  create.maxSets = 256;
  create.poolSizeCount = 4;
  create.pPoolSizes = kSizes;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  const VkResult result = vkCreateDescriptorPool(device_.handle, &create, nullptr, &pool);
  if (result != VK_SUCCESS) return vulkan_error(result, "making a descriptor pool");
  pools_.push_back(pool);
  return {};
}

Result<VkDescriptorSet> DescriptorArena::make(VkDescriptorSetLayout layout,
                                              std::span<const Descriptor> resources) {
  VkDescriptorSet set = VK_NULL_HANDLE;
  while (!set) {
    const bool fresh = current_ == pools_.size();
    if (fresh)
      if (auto grown = grow(); !grown.ok()) return grown.error();
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pools_[current_];
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &layout;
    const VkResult result = vkAllocateDescriptorSets(device_.handle, &allocate, &set);
    if (result == VK_SUCCESS) break;
    if (fresh) return vulkan_error(result, "allocating a descriptor set");
    ++current_;
  }

  std::vector<VkWriteDescriptorSet> writes;
  std::vector<VkDescriptorImageInfo> images(resources.size());
  std::vector<VkDescriptorBufferInfo> buffers(resources.size());
  for (size_t i = 0; i < resources.size(); ++i) {
    const Descriptor& r = resources[i];
    images[i] = {r.sampler, r.view, r.layout};
    buffers[i] = {r.buffer, r.offset, r.range};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = r.binding;
    write.descriptorCount = 1;
    switch (r.kind) {
      case BindingKind::sampled_image:
        write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        break;
      case BindingKind::storage_image:
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
        break;
      case BindingKind::storage_buffer:
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        break;
      case BindingKind::uniform_buffer:
        write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        break;
    }
    write.pImageInfo = &images[i];
    write.pBufferInfo = &buffers[i];
    writes.push_back(write);
  }
  vkUpdateDescriptorSets(device_.handle, static_cast<uint32_t>(writes.size()), writes.data(), 0,
                         nullptr);
  return set;
}

void DescriptorArena::reset() {
  for (VkDescriptorPool pool : pools_) vkResetDescriptorPool(device_.handle, pool, 0);
  current_ = 0;
}

TimerPool::~TimerPool() {
  if (pool_) vkDestroyQueryPool(device_.handle, pool_, nullptr);
}

bool TimerPool::begin(CommandList& commands) {
  if (!device_.properties.limits.timestampComputeAndGraphics) return false;
  if (!pool_) {
    VkQueryPoolCreateInfo create{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    create.queryType = VK_QUERY_TYPE_TIMESTAMP;
    create.queryCount = kMaxQueries;
    if (vkCreateQueryPool(device_.handle, &create, nullptr, &pool_) != VK_SUCCESS) return false;
  }
  vkCmdResetQueryPool(commands.handle(), pool_, 0, kMaxQueries);
  used_ = 0;
  return true;
}

uint32_t TimerPool::mark(CommandList& commands) {
  if (used_ == kMaxQueries) return kMaxQueries;
  commands.full_barrier();
  commands.timestamp(pool_, used_);
  commands.full_barrier();
  return used_++;
}

std::vector<double> TimerPool::read() const {
  if (!pool_ || used_ == 0) return {};
  std::vector<uint64_t> ticks(used_);
  const VkResult result =
      vkGetQueryPoolResults(device_.handle, pool_, 0, used_, ticks.size() * sizeof(uint64_t),
                            ticks.data(), sizeof(uint64_t), VK_QUERY_RESULT_64_BIT);
  if (result != VK_SUCCESS) return {};
  std::vector<double> ms;
  for (uint64_t tick : ticks)
    ms.push_back(static_cast<double>(tick - ticks[0]) *
                 static_cast<double>(device_.properties.limits.timestampPeriod) * 1e-6);
  return ms;
}

}  // namespace lueur::gpu
