// SPDX-License-Identifier: MIT
// What an engine lends to Lueur: its device, and each frame its command buffer and images.
//
//   auto context = lueur::Context::create({.instance = …, .physical_device = …, .device = …, …});
//   // each frame, after the G-buffer and before composition:
//   lueur::Frame frame = context->record(command_buffer);
//   lueur::Image depth = frame.import({.image = …, .view = …, …});
//   …                                  // a technique's render(frame, inputs) gives images
//   frame.copy(outputs.diffuse, light); // into an imported image of the engine's
//   auto status = frame.finish();      // imported images are back in the state they came in
//
// There is no hidden submit and no hidden wait.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lueur/buffer.h"
#include "lueur/image.h"
#include "lueur/result.h"

namespace lueur {

class Recorder;

// What GPU times are measured of. A timer is two timestamps between full barriers, which keep
// passes from running into each other's time, and costs what they do: leave it off in a shipped
// game.
enum class Timers : uint8_t {
  off,
  passes,    // each pass
  together,  // passes of one owner that follow each other, "owner.step", as one: "owner.*"
};

// The device must have been made with Vulkan 1.3 and the features that `missing_features` checks.
struct ContextInfo {
  PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physical_device = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  // Frames that may be under way on the device at once. When record() is called, the frame
  // recorded that many calls earlier must have completed.
  uint32_t frames_in_flight = 2;
  // Where compiled pipelines are kept between runs; empty: nowhere. A damaged or foreign file is
  // ignored and replaced.
  std::filesystem::path pipeline_cache;
  Timers timers = Timers::off;
  // The device was made with the feature logicOp, which is not required: what needs it says so.
  bool logic_op = false;
  // Debug labels and object names (needs VK_EXT_debug_utils enabled on the instance).
  bool debug_names = false;
};

// Where the memory that Lueur allocated is. Imported images are the engine's and not counted.
struct MemoryUse {
  uint64_t total_bytes = 0;  // held now
  uint64_t peak_bytes = 0;   // most ever held
};

struct PassTime {
  std::string name;  // "owner.step", or "owner.*" of several together
  double gpu_ms = 0;
};

// One frame's recording into the engine's command buffer. Movable; ends at finish(). When something
// fails, all later calls do nothing and finish() tells the first error.
class Frame {
 public:
  explicit Frame(Recorder* recorder) : recorder_(recorder) {}
  // Makes an engine's image usable by techniques in this frame.
  Image import(const ExternalImage& image);
  // The same for a buffer. It is only read, so that there is nothing to put back.
  BufferRef import(const ExternalBuffer& buffer);
  // Copies an image of Lueur's, such as a technique's output, into an imported one of the same
  // extent and format. The engine's image needs TRANSFER_DST usage.
  void copy(Image from, Image to);
  // Puts the imported images back into their state. Call it once, before the command buffer ends.
  Result<void> finish();
  Recorder& recorder() { return *recorder_; }

 private:
  Recorder* recorder_;
};

class Context {
 public:
  // Fails (ErrorKind::device) naming every missing feature at once.
  static Result<Context> create(const ContextInfo& info);
  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;
  ~Context();  // the device must have finished all frames

  // Begins a frame in a command buffer that is in the recording state, outside of rendering.
  Frame record(VkCommandBuffer command_buffer);

  // From the next frame on.
  void set_timers(Timers timers);
  // GPU times of the most recent frame that is known to have completed: call after waiting for it.
  std::vector<PassTime> pass_times();
  MemoryUse memory() const;
  Recorder& recorder() { return *recorder_; }

 private:
  Context();
  std::unique_ptr<Recorder> recorder_;
};

// Names of the features that Lueur needs and this device lacks; empty if it is good.
std::vector<std::string> missing_features(PFN_vkGetInstanceProcAddr get_instance_proc_addr,
                                          VkInstance instance, VkPhysicalDevice physical_device);

// The features to enable when the engine makes its device: chain into VkDeviceCreateInfo::pNext.
// Points into static storage.
const VkPhysicalDeviceFeatures2* required_features();

}  // namespace lueur
