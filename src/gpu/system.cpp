// SPDX-License-Identifier: MIT
#include "gpu/system.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include "base/try.h"
#include "gpu/device.h"

namespace lueur::gpu {
namespace {

std::string version_text(uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
         std::to_string(VK_API_VERSION_MINOR(version)) + "." +
         std::to_string(VK_API_VERSION_PATCH(version));
}

const char* kind_name(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "CPU";
    default:
      return "other";
  }
}

VkBool32 VKAPI_PTR collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                           const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  auto* log = static_cast<ValidationLog*>(user);
  const std::lock_guard lock(log->mutex);
  log->messages.emplace_back(data->pMessage ? data->pMessage : "");
  return VK_FALSE;
}

std::vector<VkPhysicalDevice> physical_devices(VkInstance instance) {
  uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  devices.resize(count);
  return devices;
}

DeviceEntry describe(VkInstance instance, VkPhysicalDevice physical, uint32_t index) {
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(physical, &properties);
  DeviceEntry entry;
  entry.index = index;
  entry.name = properties.properties.deviceName;
  entry.kind = kind_name(properties.properties.deviceType);
  entry.driver = std::string(driver.driverName) + " " + driver.driverInfo;
  entry.api_version = version_text(properties.properties.apiVersion);
  VkPhysicalDeviceMemoryProperties memory{};
  vkGetPhysicalDeviceMemoryProperties(physical, &memory);
  for (uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap)
    if (memory.memoryHeaps[heap].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
      entry.memory_bytes = std::max(entry.memory_bytes, memory.memoryHeaps[heap].size);
  entry.missing = missing_features(vkGetInstanceProcAddr, instance, physical);
  return entry;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// Finds the device that `wanted` means; see SystemInfo::device.
Result<uint32_t> choose(const std::vector<DeviceEntry>& devices, const std::string& wanted) {
  if (devices.empty())
    return Error{
        ErrorKind::device,
        "no Vulkan device found; install a driver (mesa-vulkan-drivers renders on the CPU)"};
  std::string list;
  for (const DeviceEntry& d : devices)
    list += (list.empty() ? "" : ", ") + std::to_string(d.index) + " = " + d.name;
  if (!wanted.empty()) {
    uint32_t number = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    const bool is_number = error == std::errc() && end == wanted.data() + wanted.size();
    for (const DeviceEntry& d : devices)
      if (is_number ? d.index == number : lower(d.name).find(lower(wanted)) != std::string::npos)
        return d.index;
    return Error{ErrorKind::usage, "--device " + wanted + ": no such device; there is " + list};
  }
  for (const DeviceEntry& d : devices)
    if (d.missing.empty() && d.kind == "discrete GPU") return d.index;
  for (const DeviceEntry& d : devices)
    if (d.missing.empty()) return d.index;
  return uint32_t{0};  // Device creation names what it lacks.
}

}  // namespace

Result<void> System::make_instance(const SystemInfo& info) {
  if (volkInitialize() != VK_SUCCESS)
    return Error{ErrorKind::device, "the Vulkan loader was not found; install libvulkan1"};
  if (volkGetInstanceVersion() < VK_API_VERSION_1_3)
    return Error{ErrorKind::device, "the Vulkan loader is older than 1.3; update libvulkan1"};

  std::vector<const char*> layers;
  std::vector<const char*> extensions;
  if (info.validation) layers.push_back("VK_LAYER_KHRONOS_validation");
  debug_names_ = info.debug_names || info.validation;
  if (debug_names_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "lueur";
  application.apiVersion = VK_API_VERSION_1_3;
  VkDebugUtilsMessengerCreateInfoEXT messenger{
      VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                              VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                          VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messenger.pfnUserCallback = collect;
  messenger.pUserData = log_.get();
  const VkValidationFeatureEnableEXT enables[] = {
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = enables;
  features.pNext = &messenger;

  VkInstanceCreateInfo create{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  create.pNext = info.validation ? &features : nullptr;
  create.pApplicationInfo = &application;
  create.enabledLayerCount = static_cast<uint32_t>(layers.size());
  create.ppEnabledLayerNames = layers.data();
  create.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
  create.ppEnabledExtensionNames = extensions.data();
  const VkResult result = vkCreateInstance(&create, nullptr, &instance_);
  if (result == VK_ERROR_LAYER_NOT_PRESENT)
    return Error{ErrorKind::device,
                 "--validate needs the Khronos validation layer; install vulkan-validationlayers"};
  if (result != VK_SUCCESS) return vulkan_error(result, "starting Vulkan");
  volkLoadInstanceOnly(instance_);
  if (info.validation) vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_);
  return {};
}

Result<void> System::make_device() {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
  const auto family = std::find_if(families.begin(), families.end(), [](const auto& f) {
    return (f.queueFlags & VK_QUEUE_GRAPHICS_BIT) && (f.queueFlags & VK_QUEUE_COMPUTE_BIT);
  });
  if (family == families.end())
    return Error{ErrorKind::device, "device " + entry_.name + " has no graphics and compute queue"};
  queue_family_ = static_cast<uint32_t>(family - families.begin());
  if (!entry_.missing.empty()) {
    std::string list;
    for (const std::string& name : entry_.missing) list += (list.empty() ? "" : ", ") + name;
    return Error{ErrorKind::device, "device " + entry_.name + " lacks " + list +
                                        "; choose another (lueur devices) or update its driver"};
  }

  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queue_family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceFeatures supported{};
  vkGetPhysicalDeviceFeatures(physical_, &supported);
  logic_op_ = supported.logicOp;
  VkPhysicalDeviceFeatures2 features = *required_features();
  features.features.logicOp = logic_op_;
  VkDeviceCreateInfo create{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  create.pNext = &features;
  create.queueCreateInfoCount = 1;
  create.pQueueCreateInfos = &queue;
  VkResult result = vkCreateDevice(physical_, &create, nullptr, &device_);
  if (result != VK_SUCCESS) return vulkan_error(result, "opening device " + entry_.name);
  volkLoadDevice(device_);
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);

  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.queueFamilyIndex = queue_family_;
  result = vkCreateCommandPool(device_, &pool, nullptr, &command_pool_);
  if (result != VK_SUCCESS) return vulkan_error(result, "making a command pool");
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = command_pool_;
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  result = vkAllocateCommandBuffers(device_, &allocate, &commands_);
  if (result != VK_SUCCESS) return vulkan_error(result, "making a command buffer");
  VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  result = vkCreateFence(device_, &fence, nullptr, &fence_);
  if (result != VK_SUCCESS) return vulkan_error(result, "making a fence");
  return {};
}

Result<std::unique_ptr<System>> System::create(const SystemInfo& info) {
  std::unique_ptr<System> system(new System);
  LUEUR_TRY_VOID(system->make_instance(info));
  const std::vector<VkPhysicalDevice> devices = physical_devices(system->instance_);
  std::vector<DeviceEntry> entries;
  for (VkPhysicalDevice device : devices)
    entries.push_back(describe(system->instance_, device, static_cast<uint32_t>(entries.size())));
  LUEUR_TRY(index, choose(entries, info.device));
  system->entry_ = entries[index];
  system->physical_ = devices[index];
  LUEUR_TRY_VOID(system->make_device());
  return system;
}

Result<std::vector<DeviceEntry>> System::list_devices() {
  std::unique_ptr<System> system(new System);
  LUEUR_TRY_VOID(system->make_instance({}));
  std::vector<DeviceEntry> entries;
  for (VkPhysicalDevice device : physical_devices(system->instance_))
    entries.push_back(describe(system->instance_, device, static_cast<uint32_t>(entries.size())));
  return entries;
}

System::~System() {
  if (device_) {
    vkDeviceWaitIdle(device_);
    vkDestroyFence(device_, fence_, nullptr);
    vkDestroyCommandPool(device_, command_pool_, nullptr);
    vkDestroyDevice(device_, nullptr);
  }
  if (messenger_) vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  if (instance_) vkDestroyInstance(instance_, nullptr);
}

ContextInfo System::context_info() const {
  ContextInfo info;
  info.get_instance_proc_addr = vkGetInstanceProcAddr;
  info.instance = instance_;
  info.physical_device = physical_;
  info.device = device_;
  info.logic_op = logic_op_;
  info.debug_names = debug_names_;
  return info;
}

Result<void> System::run(const std::function<Result<void>(VkCommandBuffer)>& record) {
  vkResetCommandPool(device_, command_pool_, 0);
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  VkResult result = vkBeginCommandBuffer(commands_, &begin);
  if (result != VK_SUCCESS) return vulkan_error(result, "recording commands");
  LUEUR_TRY_VOID(record(commands_));
  result = vkEndCommandBuffer(commands_);
  if (result != VK_SUCCESS) return vulkan_error(result, "recording commands");

  VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  commands.commandBuffer = commands_;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &commands;
  result = vkQueueSubmit2(queue_, 1, &submit, fence_);
  if (result != VK_SUCCESS) return vulkan_error(result, "submitting commands");
  result = vkWaitForFences(device_, 1, &fence_, VK_TRUE, UINT64_MAX);
  if (result != VK_SUCCESS) return vulkan_error(result, "waiting for the device");
  vkResetFences(device_, 1, &fence_);
  return {};
}

std::vector<std::string> System::validation_messages() const {
  const std::lock_guard lock(log_->mutex);
  return log_->messages;
}

}  // namespace lueur::gpu
