// SPDX-License-Identifier: MIT
#include "gpu/memory.h"

#include "base/check.h"

namespace lueur::gpu {

Result<Buffer> Buffer::create(Device& device, const BufferInfo& info) {
  VkBufferCreateInfo create{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  create.size = info.bytes;
  create.usage = info.usage;
  VmaAllocationCreateInfo where{};
  where.usage = VMA_MEMORY_USAGE_AUTO;
  if (info.kind == MemoryKind::upload)
    where.flags =
        VMA_ALLOCATION_CREATE_MAPPED_BIT | VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT;
  if (info.kind == MemoryKind::readback)
    where.flags = VMA_ALLOCATION_CREATE_MAPPED_BIT | VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT;

  Buffer buffer;
  VmaAllocationInfo allocated{};
  const VkResult result = vmaCreateBuffer(device.allocator, &create, &where, &buffer.handle_,
                                          &buffer.allocation_, &allocated);
  if (result != VK_SUCCESS)
    return vulkan_error(
        result, "allocating " + std::to_string(info.bytes) + " bytes for buffer " + info.name);
  buffer.device_ = &device;
  buffer.bytes_ = info.bytes;
  buffer.allocated_bytes_ = allocated.size;
  buffer.mapped_ = allocated.pMappedData;
  device.count_memory(static_cast<int64_t>(allocated.size));
  device.name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(buffer.handle_), info.name);
  return buffer;
}

Buffer::~Buffer() {
  if (!handle_) return;
  vmaDestroyBuffer(device_->allocator, handle_, allocation_);
  device_->count_memory(-static_cast<int64_t>(allocated_bytes_));
}

void Buffer::flush() const {
  LUEUR_CHECK(mapped_ != nullptr);
  vmaFlushAllocation(device_->allocator, allocation_, 0, VK_WHOLE_SIZE);
}

void Buffer::invalidate() const {
  LUEUR_CHECK(mapped_ != nullptr);
  vmaInvalidateAllocation(device_->allocator, allocation_, 0, VK_WHOLE_SIZE);
}

void Buffer::swap(Buffer& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(handle_, other.handle_);
  std::swap(allocation_, other.allocation_);
  std::swap(bytes_, other.bytes_);
  std::swap(allocated_bytes_, other.allocated_bytes_);
  std::swap(mapped_, other.mapped_);
}

Result<Texture> Texture::create(Device& device, const TextureInfo& info) {
  const uint32_t limit = info.cube ? device.properties.limits.maxImageDimensionCube
                                   : device.properties.limits.maxImageDimension2D;
  if (info.extent.width > limit || info.extent.height > limit || info.extent.width == 0 ||
      info.extent.height == 0)
    return Error{ErrorKind::usage,
                 "image " + info.name + " of " + std::to_string(info.extent.width) + "x" +
                     std::to_string(info.extent.height) + " pixels: this device takes 1 to " +
                     std::to_string(limit) + " a side"};

  VkImageCreateInfo create{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  if (info.cube) create.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
  create.imageType = VK_IMAGE_TYPE_2D;
  create.format = to_vk(info.format);
  create.extent = {info.extent.width, info.extent.height, 1};
  create.mipLevels = info.mip_levels;
  create.arrayLayers = info.layers;
  create.samples = VK_SAMPLE_COUNT_1_BIT;
  create.tiling = VK_IMAGE_TILING_OPTIMAL;
  create.usage = info.usage;
  VmaAllocationCreateInfo where{};
  where.usage = VMA_MEMORY_USAGE_AUTO;

  Texture texture;
  VmaAllocationInfo allocated{};
  VkResult result = vmaCreateImage(device.allocator, &create, &where, &texture.handle_,
                                   &texture.allocation_, &allocated);
  if (result != VK_SUCCESS) return vulkan_error(result, "allocating image " + info.name);
  texture.device_ = &device;
  texture.info_ = info;
  texture.allocated_bytes_ = allocated.size;
  device.count_memory(static_cast<int64_t>(allocated.size));
  device.name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(texture.handle_), info.name);

  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = texture.handle_;
  view.viewType = info.cube
                      ? VK_IMAGE_VIEW_TYPE_CUBE
                      : (info.layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D);
  view.format = create.format;
  view.subresourceRange = {texture.aspect(), 0, info.mip_levels, 0, info.layers};
  result = vkCreateImageView(device.handle, &view, nullptr, &texture.view_);
  if (result != VK_SUCCESS) return vulkan_error(result, "making a view of image " + info.name);
  for (uint32_t layer = 0; info.layers > 1 && layer < info.layers; ++layer) {
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.subresourceRange = {texture.aspect(), 0, 1, layer, 1};
    VkImageView layer_view = VK_NULL_HANDLE;
    result = vkCreateImageView(device.handle, &view, nullptr, &layer_view);
    if (result != VK_SUCCESS) return vulkan_error(result, "making a view of image " + info.name);
    texture.layer_views_.push_back(layer_view);
  }
  return texture;
}

Texture::~Texture() {
  if (!handle_) return;
  for (VkImageView layer_view : layer_views_)
    vkDestroyImageView(device_->handle, layer_view, nullptr);
  if (view_) vkDestroyImageView(device_->handle, view_, nullptr);
  vmaDestroyImage(device_->allocator, handle_, allocation_);
  device_->count_memory(-static_cast<int64_t>(allocated_bytes_));
}

VkImageAspectFlags Texture::aspect() const {
  return gpu::info(info_.format).is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

void Texture::swap(Texture& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(info_, other.info_);
  std::swap(handle_, other.handle_);
  std::swap(view_, other.view_);
  std::swap(layer_views_, other.layer_views_);
  std::swap(allocation_, other.allocation_);
  std::swap(allocated_bytes_, other.allocated_bytes_);
}

VkImageUsageFlags general_usage(Format format) {
  VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                            VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  const FormatInfo& row = gpu::info(format);
  usage |= row.is_depth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                        : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  if (!row.glsl.empty()) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
  return usage;
}

}  // namespace lueur::gpu
