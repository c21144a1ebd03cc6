// SPDX-License-Identifier: MIT
// Buffers and images with their memory. Each frees itself; the device must be done with it by then.
#pragma once

#include <span>
#include <utility>

#include "gpu/device.h"
#include "gpu/format.h"

namespace lueur::gpu {

enum class MemoryKind {
  device,    // fast for the device, not visible to the CPU
  upload,    // mapped, written by the CPU in order
  readback,  // mapped, read by the CPU
};

struct BufferInfo {
  std::string name;
  VkDeviceSize bytes = 0;
  VkBufferUsageFlags usage = 0;
  MemoryKind kind = MemoryKind::device;
};

class Buffer {
 public:
  static Result<Buffer> create(Device& device, const BufferInfo& info);
  Buffer() = default;
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Buffer();

  VkBuffer handle() const { return handle_; }
  VkDeviceSize bytes() const { return bytes_; }
  // The mapped memory (upload and readback), empty otherwise. Call flush() after writing it and
  // invalidate() before reading it.
  std::span<std::byte> mapped() const { return {static_cast<std::byte*>(mapped_), bytes_}; }
  void flush() const;
  void invalidate() const;

 private:
  void swap(Buffer& other) noexcept;
  Device* device_ = nullptr;
  VkBuffer handle_ = VK_NULL_HANDLE;
  VmaAllocation allocation_ = nullptr;
  VkDeviceSize bytes_ = 0;
  VkDeviceSize allocated_bytes_ = 0;
  void* mapped_ = nullptr;
};

struct TextureInfo {
  std::string name;
  Extent extent;
  Format format = Format::rgba16f;
  VkImageUsageFlags usage = 0;
  uint32_t mip_levels = 1;
  uint32_t layers = 1;
  bool cube = false;  // layers = 6; the view is a cube
};

// An image with one view of everything in it, and one view a layer to render into.
class Texture {
 public:
  static Result<Texture> create(Device& device, const TextureInfo& info);
  Texture() = default;
  Texture(Texture&& other) noexcept { swap(other); }
  Texture& operator=(Texture&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Texture();

  VkImage handle() const { return handle_; }
  VkImageView view() const { return view_; }
  VkImageView layer_view(uint32_t layer) const {
    return layer_views_.empty() ? view_ : layer_views_[layer];
  }
  const TextureInfo& info() const { return info_; }
  VkImageAspectFlags aspect() const;

 private:
  void swap(Texture& other) noexcept;
  Device* device_ = nullptr;
  TextureInfo info_;
  VkImage handle_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  std::vector<VkImageView> layer_views_;
  VmaAllocation allocation_ = nullptr;
  VkDeviceSize allocated_bytes_ = 0;
};

// What a format can be used for on every device that Lueur runs on.
VkImageUsageFlags general_usage(Format format);

}  // namespace lueur::gpu
