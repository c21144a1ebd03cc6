// SPDX-License-Identifier: MIT
// The commands the house records, in terms of the house's own types. Adds nothing of its own: no
// tracking, no barriers that were not asked for.
#pragma once

#include <array>
#include <functional>

#include "gpu/barrier.h"
#include "gpu/memory.h"
#include "gpu/pipeline.h"

namespace lueur::gpu {

struct ImageTransition {
  VkImage image = VK_NULL_HANDLE;
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
  Transition transition{};
};

struct BufferTransition {
  VkBuffer buffer = VK_NULL_HANDLE;
  Transition transition{};
};

struct ColorTarget {
  VkImageView view = VK_NULL_HANDLE;
  std::array<float, 4> clear{};
  bool keep = false;  // draw onto the old content, instead of clearing it
};

struct DepthTarget {
  VkImageView view = VK_NULL_HANDLE;  // none: no depth
  float clear = 0.0f;                 // 0 is infinitely far in reversed z
};

struct CopyRegion {
  uint64_t buffer_offset = 0;
  uint32_t mip_level = 0;
  uint32_t layer = 0;
  Extent extent;
};

class CommandList {
 public:
  explicit CommandList(VkCommandBuffer handle, bool labels) : handle_(handle), labels_(labels) {}
  VkCommandBuffer handle() const { return handle_; }

  void begin_label(const std::string& text);
  void end_label();

  void barrier(std::span<const ImageTransition> images, std::span<const BufferTransition> buffers);
  // Waits for all earlier work before all later work; only timers need it.
  void full_barrier();
  void timestamp(VkQueryPool pool, uint32_t query);

  void bind(const Pipeline& pipeline, uint32_t set, VkDescriptorSet descriptors);
  void push(const Pipeline& pipeline, const void* data, uint32_t bytes);
  void dispatch(const Pipeline& pipeline, uint32_t groups_x, uint32_t groups_y, uint32_t groups_z);
  // With the numbers of workgroups from a VkDispatchIndirectCommand.
  void dispatch_indirect(const Pipeline& pipeline, VkBuffer groups, uint64_t offset);

  void begin_rendering(Extent extent, std::span<const ColorTarget> colors,
                       const DepthTarget& depth);
  void bind_pipeline(const Pipeline& pipeline);
  void front_face(bool counter_clockwise);
  void cull_back_faces(bool on);
  void bind_geometry(VkBuffer vertices, VkBuffer indices);
  void draw(uint32_t vertex_count);
  void draw_indexed(uint32_t index_count, uint32_t first_index, int32_t vertex_offset,
                    uint32_t instance_count, uint32_t first_instance);
  void end_rendering();

  // The image must be in TRANSFER_SRC or TRANSFER_DST layout.
  void copy_to_buffer(VkImage image, VkImageAspectFlags aspect, VkBuffer buffer,
                      const CopyRegion& region);
  void copy_to_image(VkBuffer buffer, VkImage image, std::span<const CopyRegion> regions);
  void copy_image(VkImage from, VkImage to, Extent extent, bool is_depth);
  void copy_buffer(VkBuffer from, uint64_t from_offset, VkBuffer to, uint64_t to_offset,
                   uint64_t bytes);
  void fill_buffer(VkBuffer buffer, uint32_t value);

 private:
  VkCommandBuffer handle_;
  bool labels_;
};

enum class Filter : uint8_t { nearest, linear };
enum class Address : uint8_t { repeat, clamp_to_edge, mirrored_repeat };

struct SamplerState {
  Filter filter = Filter::nearest;
  Address u = Address::clamp_to_edge;
  Address v = Address::clamp_to_edge;
  bool mipmaps = false;  // trilinear, anisotropic where the device can
  bool compare = false;  // shadow maps: passes where the reference is nearer or equal (reversed z)
  friend auto operator<=>(const SamplerState&, const SamplerState&) = default;
};

// Samplers by what they are made of.
class SamplerLibrary {
 public:
  explicit SamplerLibrary(Device& device) : device_(device) {}
  ~SamplerLibrary();
  SamplerLibrary(const SamplerLibrary&) = delete;
  SamplerLibrary& operator=(const SamplerLibrary&) = delete;
  VkSampler get(const SamplerState& state);

 private:
  Device& device_;
  std::map<SamplerState, VkSampler> samplers_;
};

// One resource for one binding.
struct Descriptor {
  uint32_t binding = 0;
  BindingKind kind = BindingKind::sampled_image;
  VkImageView view = VK_NULL_HANDLE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkSampler sampler = VK_NULL_HANDLE;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  VkDeviceSize range = VK_WHOLE_SIZE;
};

// Descriptor sets that live until reset().
class DescriptorArena {
 public:
  explicit DescriptorArena(Device& device) : device_(device) {}
  ~DescriptorArena();
  DescriptorArena(const DescriptorArena&) = delete;
  DescriptorArena& operator=(const DescriptorArena&) = delete;

  Result<VkDescriptorSet> make(VkDescriptorSetLayout layout, std::span<const Descriptor> resources);
  void reset();

 private:
  Result<void> grow();
  Device& device_;
  std::vector<VkDescriptorPool> pools_;
  size_t current_ = 0;
};

// Timestamps of one frame.
class TimerPool {
 public:
  static constexpr uint32_t kMaxQueries = 512;
  explicit TimerPool(Device& device) : device_(device) {}
  ~TimerPool();
  TimerPool(const TimerPool&) = delete;
  TimerPool& operator=(const TimerPool&) = delete;

  // Makes the pool ready for a new frame; false if the queue has no timestamps.
  bool begin(CommandList& commands);
  // Takes the time between two barriers. Index of the new query, or kMaxQueries when all are used.
  uint32_t mark(CommandList& commands);
  // Milliseconds since an arbitrary start, of each query; empty if the frame is not complete.
  std::vector<double> read() const;

 private:
  Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  uint32_t used_ = 0;
};

}  // namespace lueur::gpu
