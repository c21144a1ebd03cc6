// SPDX-License-Identifier: MIT
// A shader's SPIR-V as embedded at build time, and what reflection finds in it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/vulkan.h"
#include "lueur/result.h"

namespace lueur::gpu {

// Made by the build for each GLSL file; lives as long as the program.
struct ShaderCode {
  std::string_view name;  // path below src/, e.g. "techniques/hierarchical/gather.comp"
  std::span<const uint32_t> words;
};

enum class BindingKind {
  sampled_image,   // sampler2D and the like
  storage_image,   // image2D
  storage_buffer,  // buffer { … }
  uniform_buffer,  // uniform { … }
};

struct ShaderBinding {
  std::string name;  // the variable's name in GLSL; a block's instance or block name
  uint32_t set = 0;
  uint32_t binding = 0;
  BindingKind kind = BindingKind::sampled_image;
  bool writes = false;                    // not declared readonly
  VkFormat format = VK_FORMAT_UNDEFINED;  // of a storage image
  uint32_t bytes = 0;  // of a uniform buffer, or of a storage buffer's fixed part
};

struct ShaderMember {
  std::string name;
  uint32_t offset = 0;
  uint32_t bytes = 0;
};

struct ShaderInterface {
  std::vector<ShaderBinding> bindings;
  uint32_t push_constant_bytes = 0;
  std::vector<ShaderMember> push_constants;
  // Members of each uniform or storage block by binding name, arrays of structures by their
  // element.
  std::vector<std::pair<std::string, std::vector<ShaderMember>>> blocks;
  uint32_t workgroup_size[3] = {1, 1, 1};
  std::vector<std::pair<uint32_t, std::string>> specialization_constants;  // id and name
};

// Fails (ErrorKind::device) on SPIR-V that cannot be understood.
Result<ShaderInterface> reflect(const ShaderCode& code);

}  // namespace lueur::gpu
