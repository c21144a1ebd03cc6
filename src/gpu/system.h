// SPDX-License-Identifier: MIT
// The program's own instance, device and queue: what an engine has already, and lends.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "gpu/vulkan.h"
#include "lueur/context.h"

namespace lueur::gpu {

struct DeviceEntry {
  uint32_t index = 0;  // what --device takes
  std::string name;
  std::string kind;    // "discrete GPU", "CPU", …
  std::string driver;  // name and version
  std::string api_version;
  uint64_t memory_bytes = 0;         // of the largest device-local heap
  std::vector<std::string> missing;  // features that Lueur needs and this device lacks
};

struct SystemInfo {
  // A device's number, or a part of its name (case does not matter). Empty: the first discrete GPU
  // that has all features, else the first device that has them.
  std::string device;
  // Core and synchronization validation; what they say is collected in validation_messages().
  bool validation = false;
  bool debug_names = false;
};

// Names of validation messages collected so far; shared with Vulkan's callback.
struct ValidationLog {
  std::mutex mutex;
  std::vector<std::string> messages;
};

class System {
 public:
  static Result<std::unique_ptr<System>> create(const SystemInfo& info);
  static Result<std::vector<DeviceEntry>> list_devices();
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  // What to make a Context from.
  ContextInfo context_info() const;
  const DeviceEntry& device() const { return entry_; }

  // Records with `record`, submits, and waits until the device is done. An error of `record` is
  // handed on and nothing is submitted.
  Result<void> run(const std::function<Result<void>(VkCommandBuffer)>& record);

  std::vector<std::string> validation_messages() const;

 private:
  System() = default;
  Result<void> make_instance(const SystemInfo& info);
  Result<void> make_device();

  std::unique_ptr<ValidationLog> log_ = std::make_unique<ValidationLog>();
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  uint32_t queue_family_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool command_pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  DeviceEntry entry_;
  bool logic_op_ = false;
  bool debug_names_ = false;
};

}  // namespace lueur::gpu
