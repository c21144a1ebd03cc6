// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "gpu/vulkan.h"
#include "lueur/image.h"

namespace lueur::gpu {

struct FormatInfo {
  Format format;
  VkFormat vk;
  std::string_view name;  // as in the Format enumeration
  std::string_view glsl;  // image format qualifier in a shader; empty: no storage image
  uint32_t bytes_per_pixel;
  uint32_t channels;
  bool is_float;  // may hold NaN, infinity and negative values
  bool is_depth;
};

const FormatInfo& info(Format format);
inline VkFormat to_vk(Format format) {
  return info(format).vk;
}

}  // namespace lueur::gpu
