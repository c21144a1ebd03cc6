// SPDX-License-Identifier: MIT
// The device that everything in this folder works on, borrowed from the engine or the program.
#pragma once

#include <vk_mem_alloc.h>

#include <memory>
#include <string>
#include <vector>

#include "gpu/vulkan.h"
#include "lueur/context.h"

namespace lueur::gpu {

// Vulkan's handles, the allocator and the limits that matter. Does not own instance and device.
// Volk's table serves one device at a time in a process.
class Device {
 public:
  static Result<std::unique_ptr<Device>> create(const ContextInfo& info);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkDevice handle = VK_NULL_HANDLE;
  VmaAllocator allocator = nullptr;
  VkPhysicalDeviceProperties properties{};
  bool debug_names = false;
  bool logic_op = false;  // LogicOp other than copy may be used

  // Names an object for validation messages and frame debuggers; a no-op without debug_names.
  void name(VkObjectType type, uint64_t object, const std::string& text) const;

  // Book-keeping of what Buffer and Texture allocate.
  void count_memory(int64_t bytes);
  MemoryUse memory() const { return memory_; }

 private:
  Device() = default;
  MemoryUse memory_;
};

// An error for a failed Vulkan call: "device: creating a pipeline failed: VK_ERROR_…; remedy".
Error vulkan_error(VkResult result, const std::string& doing_what);
const char* result_name(VkResult result);

}  // namespace lueur::gpu
