// SPDX-License-Identifier: MIT
// Images as they pass between an engine and Lueur.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace lueur {

struct Extent {
  uint32_t width = 0;   // pixels
  uint32_t height = 0;  // pixels
  friend bool operator==(const Extent&, const Extent&) = default;
};

// Names follow the channels, their bits and their kind; each maps to one VkFormat.
enum class Format : uint8_t {
  r8,          // VK_FORMAT_R8_UNORM
  rg8,         // VK_FORMAT_R8G8_UNORM
  rgba8,       // VK_FORMAT_R8G8B8A8_UNORM
  rgba8_srgb,  // VK_FORMAT_R8G8B8A8_SRGB
  rg16_snorm,  // VK_FORMAT_R16G16_SNORM
  r16f,        // VK_FORMAT_R16_SFLOAT
  rg16f,       // VK_FORMAT_R16G16_SFLOAT
  rgba16f,     // VK_FORMAT_R16G16B16A16_SFLOAT
  r32f,        // VK_FORMAT_R32_SFLOAT
  rgba32f,     // VK_FORMAT_R32G32B32A32_SFLOAT
  r32ui,       // VK_FORMAT_R32_UINT
  rgba32ui,    // VK_FORMAT_R32G32B32A32_UINT
  d32f,        // VK_FORMAT_D32_SFLOAT
};

// A handle, valid for the frame that gave it. Copying it copies no pixels.
struct Image {
  static constexpr uint32_t kInvalid = ~uint32_t{0};
  uint32_t index = kInvalid;
  Extent extent;
  Format format = Format::rgba16f;
  bool valid() const { return index != kInvalid; }
};

// An engine's image, lent for one frame. Lueur reads it where the technique's Inputs say so and
// leaves it, when the frame ends, in the layout it came in. `last_stage` and `last_access` tell who
// wrote it before: Lueur waits for them. After the frame, work that Lueur did on the image is
// complete for `last_stage` and `last_access` again.
struct ExternalImage {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;  // 2D, one mip level, one layer, all of the format's aspects
  Format format = Format::rgba16f;
  Extent extent;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkPipelineStageFlags2 last_stage = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkAccessFlags2 last_access = VK_ACCESS_2_MEMORY_WRITE_BIT;
};

}  // namespace lueur
