// SPDX-License-Identifier: MIT
#include "renderer/upload.h"

#include <cstring>

#include "base/try.h"

namespace lueur {
namespace {

constexpr uint64_t kBatchBytes = uint64_t{32} << 20;
constexpr uint64_t kAlignment = 16;

}  // namespace

// Returns where in the staging buffer the bytes are. Makes room first, if need be.
Result<uint64_t> Uploader::stage(std::span<const std::byte> bytes) {
  if (used_ + bytes.size() > staging_.bytes()) {
    LUEUR_TRY_VOID(flush());
    if (bytes.size() > staging_.bytes()) {
      LUEUR_TRY(buffer, gpu::Buffer::create(device_,
                                            {.name = "staging",
                                             .bytes = std::max<uint64_t>(bytes.size(), kBatchBytes),
                                             .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                             .kind = gpu::MemoryKind::upload}));
      staging_ = std::move(buffer);
    }
  }
  const uint64_t offset = used_;
  std::memcpy(staging_.mapped().data() + offset, bytes.data(), bytes.size());
  used_ += (bytes.size() + kAlignment - 1) / kAlignment * kAlignment;
  return offset;
}

Result<void> Uploader::to_buffer(std::span<const std::byte> bytes, gpu::Buffer& target) {
  for (uint64_t done = 0; done < bytes.size(); done += kBatchBytes) {
    const auto part = bytes.subspan(done, std::min<uint64_t>(kBatchBytes, bytes.size() - done));
    LUEUR_TRY(offset, stage(part));
    pending_.push_back([this, from = offset, to = target.handle(), done,
                        size = part.size()](gpu::CommandList& commands) {
      commands.copy_buffer(staging_.handle(), from, to, done, size);
    });
  }
  return {};
}

Result<void> Uploader::to_texture(std::span<const std::span<const uint8_t>> levels,
                                  std::span<const Extent> extents, gpu::Texture& target) {
  std::vector<std::byte> packed;
  std::vector<gpu::CopyRegion> regions;
  for (size_t level = 0; level < levels.size(); ++level) {
    regions.push_back({.buffer_offset = packed.size(),
                       .mip_level = static_cast<uint32_t>(level),
                       .extent = extents[level]});
    const auto bytes = std::as_bytes(levels[level]);
    packed.insert(packed.end(), bytes.begin(), bytes.end());
  }
  LUEUR_TRY(offset, stage(packed));
  for (gpu::CopyRegion& region : regions) region.buffer_offset += offset;
  pending_.push_back([this, regions, image = target.handle()](gpu::CommandList& commands) {
    gpu::AccessState state;
    const auto to_copy = gpu::advance(state, gpu::info(gpu::Use::copy_target), true, true);
    const gpu::ImageTransition before{image, VK_IMAGE_ASPECT_COLOR_BIT, *to_copy};
    commands.barrier(std::span(&before, 1), {});
    commands.copy_to_image(staging_.handle(), image, regions);
    const auto to_read = gpu::advance(state, gpu::info(gpu::Use::graphics_sampled), true, false);
    const gpu::ImageTransition after{image, VK_IMAGE_ASPECT_COLOR_BIT, *to_read};
    commands.barrier(std::span(&after, 1), {});
  });
  return {};
}

Result<void> Uploader::flush() {
  if (pending_.empty()) return {};
  staging_.flush();
  LUEUR_TRY_VOID(system_.run([&](VkCommandBuffer buffer) -> Result<void> {
    gpu::CommandList commands(buffer, false);
    for (const auto& record : pending_) record(commands);
    return {};
  }));
  pending_.clear();
  used_ = 0;
  return {};
}

}  // namespace lueur
