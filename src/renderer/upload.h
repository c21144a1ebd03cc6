// SPDX-License-Identifier: MIT
// Brings data of any size into device memory, in batches through one staging buffer.
#pragma once

#include <span>

#include "gpu/command_list.h"
#include "gpu/system.h"

namespace lueur {

class Uploader {
 public:
  Uploader(gpu::System& system, gpu::Device& device) : system_(system), device_(device) {}

  // The target must have TRANSFER_DST usage; it may be used once flush() is done.
  Result<void> to_buffer(std::span<const std::byte> bytes, gpu::Buffer& target);
  // All levels, finest first, tightly packed RGBA; the image ends in SHADER_READ_ONLY_OPTIMAL.
  Result<void> to_texture(std::span<const std::span<const uint8_t>> levels,
                          std::span<const Extent> extents, gpu::Texture& target);
  // Submits what is pending and waits for it.
  Result<void> flush();

 private:
  Result<uint64_t> stage(std::span<const std::byte> bytes);

  gpu::System& system_;
  gpu::Device& device_;
  gpu::Buffer staging_;
  uint64_t used_ = 0;
  std::vector<std::function<void(gpu::CommandList&)>> pending_;
};

}  // namespace lueur
