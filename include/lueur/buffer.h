// SPDX-License-Identifier: MIT
// Buffers as they pass between an engine and Lueur.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

#include "lueur/image.h"

namespace lueur {

// A handle, valid for the frame that gave it. Copying it copies no bytes.
struct BufferRef {
  uint32_t index = Image::kInvalid;
  bool valid() const { return index != Image::kInvalid; }
};

// An engine's buffer, lent for one frame and only read. It needs STORAGE_BUFFER usage.
// `last_stage` and `last_access` tell who wrote it before: Lueur waits for them.
struct ExternalBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  uint64_t bytes = 0;
  VkPipelineStageFlags2 last_stage = VK_PIPELINE_STAGE_2_NONE;
  VkAccessFlags2 last_access = VK_ACCESS_2_NONE;
};

}  // namespace lueur
