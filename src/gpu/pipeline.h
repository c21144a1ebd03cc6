// SPDX-License-Identifier: MIT
// Pipelines, made from shaders and checked against their reflection; kept by what they are made of,
// and on disk between runs.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "gpu/device.h"
#include "gpu/format.h"
#include "gpu/shader.h"

namespace lueur::gpu {

enum class DepthTest : uint8_t { none, nearer_reversed, nearer_or_equal_reversed };

// What becomes of a colour target's bits. All but `copy` are for integer formats, and only where
// Device::logic_op says so.
enum class LogicOp : uint8_t { copy, bit_xor, bit_or };

struct VertexAttribute {
  VkFormat format = VK_FORMAT_R32G32B32_SFLOAT;
  uint32_t offset_bytes = 0;  // the location is the attribute's place in the list
  friend bool operator==(const VertexAttribute&, const VertexAttribute&) = default;
};

// Everything of a graphics pipeline that is not dynamic state. Viewport, scissor, culling and front
// face are dynamic; primitives are triangle lists.
struct GraphicsState {
  const ShaderCode* vertex = nullptr;
  const ShaderCode* fragment = nullptr;  // none: depth only
  std::vector<Format> color_formats;
  bool has_depth = false;  // d32f
  DepthTest depth_test = DepthTest::none;
  bool depth_clamp = false;
  LogicOp logic_op = LogicOp::copy;
  float depth_bias_slope = 0.0f;
  std::vector<VertexAttribute> vertex_attributes;
  uint32_t vertex_stride_bytes = 0;
};

struct Specialization {
  std::string name;  // as in the shader
  uint32_t value = 0;
};

// A pipeline with its merged interface. Owned by the library.
struct Pipeline {
  std::string name;
  VkPipelineBindPoint bind_point = VK_PIPELINE_BIND_POINT_COMPUTE;
  VkPipeline handle = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  std::vector<VkDescriptorSetLayout> set_layouts;
  ShaderInterface interface;  // of all stages; bindings sorted by set and number
  VkShaderStageFlags stages = 0;

  // The binding of this name, or none.
  const ShaderBinding* find(std::string_view binding_name) const;
};

class PipelineLibrary {
 public:
  // Reads `cache_file` if it is there and fits this device.
  PipelineLibrary(Device& device, std::filesystem::path cache_file);
  ~PipelineLibrary();
  PipelineLibrary(const PipelineLibrary&) = delete;
  PipelineLibrary& operator=(const PipelineLibrary&) = delete;

  // `specialization` names that the shader does not have are a broken promise.
  Result<const Pipeline*> compute(const ShaderCode& shader,
                                  std::span<const Specialization> specialization);
  Result<const Pipeline*> graphics(const GraphicsState& state);

  // Writes the cache file if a pipeline was made since it was read. Failing to is not an error:
  // the next run is only slower.
  void save();

 private:
  Result<VkShaderModule> make_module(const ShaderCode& code);
  Result<void> make_layout(Pipeline& pipeline);

  Device& device_;
  std::filesystem::path cache_file_;
  VkPipelineCache cache_ = VK_NULL_HANDLE;
  bool changed_ = false;
  std::map<std::string, std::unique_ptr<Pipeline>> pipelines_;
};

}  // namespace lueur::gpu
