// SPDX-License-Identifier: MIT
#include "gpu/device.h"

#include <algorithm>

#include "base/check.h"

namespace lueur {
namespace {

// One row a feature: where it lives in the query, and its name in the specification.
struct Features {
  VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  Features() {
    core.pNext = &v12;
    v12.pNext = &v13;
  }
};

struct FeatureRow {
  const char* name;
  VkBool32& (*get)(Features&);
};

constexpr FeatureRow kRequired[] = {
    {"dynamicRendering", [](Features& f) -> VkBool32& { return f.v13.dynamicRendering; }},
    {"synchronization2", [](Features& f) -> VkBool32& { return f.v13.synchronization2; }},
    {"maintenance4", [](Features& f) -> VkBool32& { return f.v13.maintenance4; }},
    {"robustImageAccess", [](Features& f) -> VkBool32& { return f.v13.robustImageAccess; }},
    {"scalarBlockLayout", [](Features& f) -> VkBool32& { return f.v12.scalarBlockLayout; }},
    {"shaderStorageImageExtendedFormats",
     [](Features& f) -> VkBool32& { return f.core.features.shaderStorageImageExtendedFormats; }},
    {"fragmentStoresAndAtomics",
     [](Features& f) -> VkBool32& { return f.core.features.fragmentStoresAndAtomics; }},
    {"depthClamp", [](Features& f) -> VkBool32& { return f.core.features.depthClamp; }},
};

}  // namespace

std::vector<std::string> missing_features(PFN_vkGetInstanceProcAddr get_instance_proc_addr,
                                          VkInstance instance, VkPhysicalDevice physical_device) {
  const auto get_properties = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(
      get_instance_proc_addr(instance, "vkGetPhysicalDeviceProperties"));
  VkPhysicalDeviceProperties properties{};
  get_properties(physical_device, &properties);
  if (properties.apiVersion < VK_API_VERSION_1_3)
    return {"Vulkan 1.3 (this device has " +
            std::to_string(VK_API_VERSION_MAJOR(properties.apiVersion)) + "." +
            std::to_string(VK_API_VERSION_MINOR(properties.apiVersion)) + ")"};

  const auto get_features = reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures2>(
      get_instance_proc_addr(instance, "vkGetPhysicalDeviceFeatures2"));
  Features features;
  get_features(physical_device, &features.core);
  std::vector<std::string> missing;
  for (const FeatureRow& row : kRequired)
    if (!row.get(features)) missing.push_back(row.name);
  return missing;
}

const VkPhysicalDeviceFeatures2* required_features() {
  static Features features = [] {
    Features wanted;
    for (const FeatureRow& row : kRequired) row.get(wanted) = VK_TRUE;
    return wanted;
  }();
  features.core.pNext = &features.v12;
  features.v12.pNext = &features.v13;
  return &features.core;
}

namespace gpu {

const char* result_name(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST:
      return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "VK_ERROR_LAYER_NOT_PRESENT";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "VK_ERROR_EXTENSION_NOT_PRESENT";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "VK_ERROR_FEATURE_NOT_PRESENT";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
      return "VK_ERROR_FORMAT_NOT_SUPPORTED";
    case VK_ERROR_FRAGMENTED_POOL:
      return "VK_ERROR_FRAGMENTED_POOL";
    case VK_ERROR_OUT_OF_POOL_MEMORY:
      return "VK_ERROR_OUT_OF_POOL_MEMORY";
    default:
      return "an unexpected VkResult";
  }
}

Error vulkan_error(VkResult result, const std::string& doing_what) {
  const bool memory = result == VK_ERROR_OUT_OF_HOST_MEMORY ||
                      result == VK_ERROR_OUT_OF_DEVICE_MEMORY ||
                      result == VK_ERROR_OUT_OF_POOL_MEMORY;
  std::string message = doing_what + " failed: " + result_name(result);
  if (memory) message += "; render at a smaller size or close other programs";
  if (result == VK_ERROR_DEVICE_LOST) message += "; the driver gave up, update it or try --device";
  return {memory ? ErrorKind::memory : ErrorKind::device, message};
}

Result<std::unique_ptr<Device>> Device::create(const ContextInfo& info) {
  const std::vector<std::string> missing =
      missing_features(info.get_instance_proc_addr, info.instance, info.physical_device);
  if (!missing.empty()) {
    std::string list;
    for (const std::string& name : missing) list += (list.empty() ? "" : ", ") + name;
    return Error{ErrorKind::device, "the device lacks " + list +
                                        "; choose another (lueur devices) or update its driver"};
  }
  volkInitializeCustom(info.get_instance_proc_addr);
  volkLoadInstance(info.instance);
  volkLoadDevice(info.device);

  std::unique_ptr<Device> device(new Device);
  device->physical = info.physical_device;
  device->handle = info.device;
  device->logic_op = info.logic_op;
  device->debug_names = info.debug_names && vkSetDebugUtilsObjectNameEXT != nullptr;
  vkGetPhysicalDeviceProperties(info.physical_device, &device->properties);

  VmaVulkanFunctions functions{};
  functions.vkGetInstanceProcAddr = info.get_instance_proc_addr;
  functions.vkGetDeviceProcAddr = vkGetDeviceProcAddr;
  VmaAllocatorCreateInfo create{};
  create.instance = info.instance;
  create.physicalDevice = info.physical_device;
  create.device = info.device;
  create.vulkanApiVersion = VK_API_VERSION_1_3;
  create.pVulkanFunctions = &functions;
  const VkResult result = vmaCreateAllocator(&create, &device->allocator);
  if (result != VK_SUCCESS) return vulkan_error(result, "creating the memory allocator");
  return device;
}

Device::~Device() {
  if (allocator) vmaDestroyAllocator(allocator);
}

void Device::name(VkObjectType type, uint64_t object, const std::string& text) const {
  if (!debug_names) return;
  VkDebugUtilsObjectNameInfoEXT name_info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  name_info.objectType = type;
  name_info.objectHandle = object;
  name_info.pObjectName = text.c_str();
  vkSetDebugUtilsObjectNameEXT(handle, &name_info);
}

void Device::count_memory(int64_t bytes) {
  memory_.total_bytes = static_cast<uint64_t>(static_cast<int64_t>(memory_.total_bytes) + bytes);
  memory_.peak_bytes = std::max(memory_.peak_bytes, memory_.total_bytes);
}

}  // namespace gpu
}  // namespace lueur
