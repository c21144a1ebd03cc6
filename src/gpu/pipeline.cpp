// SPDX-License-Identifier: MIT
#include "gpu/pipeline.h"

#include <algorithm>
#include <cstring>

#include "base/check.h"
#include "base/file.h"
#include "base/try.h"

namespace lueur::gpu {
namespace {

constexpr uint64_t kMaxCacheBytes = uint64_t{64} << 20;

VkDescriptorType descriptor_type(BindingKind kind) {
  switch (kind) {
    case BindingKind::sampled_image:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case BindingKind::storage_image:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case BindingKind::storage_buffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingKind::uniform_buffer:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

// True if a pipeline cache file was written by this very driver and device.
bool fits(const std::vector<uint8_t>& file, const VkPhysicalDeviceProperties& properties) {
  VkPipelineCacheHeaderVersionOne header{};
  if (file.size() < sizeof(header)) return false;
  std::memcpy(&header, file.data(), sizeof(header));
  // Read apart: what a damaged file holds may be no value of the enumeration.
  uint32_t version = 0;
  std::memcpy(&version, file.data() + offsetof(VkPipelineCacheHeaderVersionOne, headerVersion),
              sizeof(version));
  return version == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
         header.vendorID == properties.vendorID && header.deviceID == properties.deviceID &&
         std::memcmp(header.pipelineCacheUUID, properties.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

// Adds a stage's interface to a pipeline's. The same binding may appear in both stages.
void merge(ShaderInterface& into, const ShaderInterface& stage, const std::string& pipeline_name) {
  for (const ShaderBinding& binding : stage.bindings) {
    const auto same = std::find_if(into.bindings.begin(), into.bindings.end(), [&](const auto& b) {
      return b.set == binding.set && b.binding == binding.binding;
    });
    if (same == into.bindings.end()) {
      into.bindings.push_back(binding);
      continue;
    }
    if (same->name != binding.name || same->kind != binding.kind)
      check_failed(__FILE__, __LINE__, "stages agree on their bindings",
                   pipeline_name + ": " + same->name + " and " + binding.name);
    same->writes = same->writes || binding.writes;
  }
  if (stage.push_constant_bytes > into.push_constant_bytes) {
    into.push_constant_bytes = stage.push_constant_bytes;
    into.push_constants = stage.push_constants;
  }
  into.blocks.insert(into.blocks.end(), stage.blocks.begin(), stage.blocks.end());
}

VkPipelineRasterizationStateCreateInfo raster_state(const GraphicsState& state) {
  VkPipelineRasterizationStateCreateInfo raster{
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.depthClampEnable = state.depth_clamp;
  raster.polygonMode = VK_POLYGON_MODE_FILL;
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.depthBiasEnable = state.depth_bias_slope != 0.0f;
  raster.depthBiasSlopeFactor = state.depth_bias_slope;
  raster.lineWidth = 1.0f;
  return raster;
}

VkPipelineDepthStencilStateCreateInfo depth_state(const GraphicsState& state) {
  VkPipelineDepthStencilStateCreateInfo depth{
      VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = state.depth_test != DepthTest::none;
  depth.depthWriteEnable = state.depth_test != DepthTest::none;
  depth.depthCompareOp = state.depth_test == DepthTest::nearer_or_equal_reversed
                             ? VK_COMPARE_OP_GREATER_OR_EQUAL
                             : VK_COMPARE_OP_GREATER;
  return depth;
}

VkLogicOp to_vk(LogicOp op) {
  switch (op) {
    case LogicOp::copy:
      return VK_LOGIC_OP_COPY;
    case LogicOp::bit_xor:
      return VK_LOGIC_OP_XOR;
    case LogicOp::bit_or:
      return VK_LOGIC_OP_OR;
  }
  return VK_LOGIC_OP_COPY;
}

// A string that is equal exactly if the pipelines are.
std::string key_of(const GraphicsState& s) {
  std::string key = "graphics " + std::string(s.vertex->name) + " " +
                    (s.fragment ? std::string(s.fragment->name) : "-");
  for (Format format : s.color_formats) key += " " + std::string(info(format).name);
  key += " d" + std::to_string(s.has_depth) + std::to_string(static_cast<int>(s.depth_test)) +
         " c" + std::to_string(s.depth_clamp) + " l" +
         std::to_string(static_cast<int>(s.logic_op)) + " b" + std::to_string(s.depth_bias_slope) +
         " v" + std::to_string(s.vertex_stride_bytes);
  for (const VertexAttribute& a : s.vertex_attributes)
    key += " " + std::to_string(a.format) + "@" + std::to_string(a.offset_bytes);
  return key;
}

}  // namespace

const ShaderBinding* Pipeline::find(std::string_view binding_name) const {
  for (const ShaderBinding& binding : interface.bindings)
    if (binding.name == binding_name) return &binding;
  return nullptr;
}

PipelineLibrary::PipelineLibrary(Device& device, std::filesystem::path cache_file)
    : device_(device), cache_file_(std::move(cache_file)) {
  std::vector<uint8_t> stored;
  if (!cache_file_.empty())
    if (auto file = read_file(cache_file_, kMaxCacheBytes); file.ok()) stored = std::move(*file);
  if (!fits(stored, device.properties)) stored.clear();
  VkPipelineCacheCreateInfo create{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  create.initialDataSize = stored.size();
  create.pInitialData = stored.data();
  // A driver that rejects the data leaves us without a cache, which only costs time.
  if (vkCreatePipelineCache(device.handle, &create, nullptr, &cache_) != VK_SUCCESS)
    cache_ = VK_NULL_HANDLE;
}

PipelineLibrary::~PipelineLibrary() {
  save();
  for (auto& [key, pipeline] : pipelines_) {
    vkDestroyPipeline(device_.handle, pipeline->handle, nullptr);
    vkDestroyPipelineLayout(device_.handle, pipeline->layout, nullptr);
    for (VkDescriptorSetLayout layout : pipeline->set_layouts)
      vkDestroyDescriptorSetLayout(device_.handle, layout, nullptr);
  }
  if (cache_) vkDestroyPipelineCache(device_.handle, cache_, nullptr);
}

void PipelineLibrary::save() {
  if (!changed_ || cache_file_.empty() || !cache_) return;
  size_t bytes = 0;
  vkGetPipelineCacheData(device_.handle, cache_, &bytes, nullptr);
  std::vector<uint8_t> data(bytes);
  if (vkGetPipelineCacheData(device_.handle, cache_, &bytes, data.data()) != VK_SUCCESS) return;
  data.resize(bytes);
  std::error_code ignored;
  std::filesystem::create_directories(cache_file_.parent_path(), ignored);
  changed_ = !write_file(cache_file_, data).ok();
}

Result<VkShaderModule> PipelineLibrary::make_module(const ShaderCode& code) {
  VkShaderModuleCreateInfo create{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  create.codeSize = code.words.size_bytes();
  create.pCode = code.words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  const VkResult result = vkCreateShaderModule(device_.handle, &create, nullptr, &module);
  if (result != VK_SUCCESS) return vulkan_error(result, "loading shader " + std::string(code.name));
  return module;
}

Result<void> PipelineLibrary::make_layout(Pipeline& pipeline) {
  auto& bindings = pipeline.interface.bindings;
  std::sort(bindings.begin(), bindings.end(), [](const auto& a, const auto& b) {
    return std::pair(a.set, a.binding) < std::pair(b.set, b.binding);
  });
  const uint32_t set_count = bindings.empty() ? 1 : bindings.back().set + 1;
  for (uint32_t set = 0; set < set_count; ++set) {
    std::vector<VkDescriptorSetLayoutBinding> layout_bindings;
    for (const ShaderBinding& b : bindings)
      if (b.set == set)
        layout_bindings.push_back(
            {b.binding, descriptor_type(b.kind), 1, pipeline.stages, nullptr});
    VkDescriptorSetLayoutCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    create.bindingCount = static_cast<uint32_t>(layout_bindings.size());
    create.pBindings = layout_bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    const VkResult result = vkCreateDescriptorSetLayout(device_.handle, &create, nullptr, &layout);
    if (result != VK_SUCCESS) return vulkan_error(result, "making a layout for " + pipeline.name);
    pipeline.set_layouts.push_back(layout);
  }

  const uint32_t push_limit = device_.properties.limits.maxPushConstantsSize;
  LUEUR_CHECK_OP(pipeline.interface.push_constant_bytes, <=, push_limit);
  const VkPushConstantRange push{pipeline.stages, 0, pipeline.interface.push_constant_bytes};
  VkPipelineLayoutCreateInfo create{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  create.setLayoutCount = set_count;
  create.pSetLayouts = pipeline.set_layouts.data();
  create.pushConstantRangeCount = push.size > 0 ? 1 : 0;
  create.pPushConstantRanges = &push;
  const VkResult result =
      vkCreatePipelineLayout(device_.handle, &create, nullptr, &pipeline.layout);
  if (result != VK_SUCCESS) return vulkan_error(result, "making a layout for " + pipeline.name);
  return {};
}

Result<const Pipeline*> PipelineLibrary::compute(const ShaderCode& shader,
                                                 std::span<const Specialization> specialization) {
  std::string key(shader.name);
  for (const Specialization& s : specialization)
    key += " " + s.name + "=" + std::to_string(s.value);
  if (const auto found = pipelines_.find(key); found != pipelines_.end())
    return found->second.get();

  auto pipeline = std::make_unique<Pipeline>();
  pipeline->name = key;
  pipeline->stages = VK_SHADER_STAGE_COMPUTE_BIT;
  LUEUR_TRY(reflected, reflect(shader));
  pipeline->interface = reflected;
  LUEUR_TRY_VOID(make_layout(*pipeline));

  // Match specialization constants by name, as everything else.
  std::vector<VkSpecializationMapEntry> entries;
  std::vector<uint32_t> values;
  for (const Specialization& s : specialization) {
    const auto& known = pipeline->interface.specialization_constants;
    const auto match = std::find_if(known.begin(), known.end(), [&](const auto& constant) {
      return constant.second == s.name;
    });
    if (match == known.end())
      check_failed(__FILE__, __LINE__, "the shader has this specialization constant", key);
    entries.push_back(
        {match->first, static_cast<uint32_t>(values.size() * sizeof(uint32_t)), sizeof(uint32_t)});
    values.push_back(s.value);
  }
  const VkSpecializationInfo special{static_cast<uint32_t>(entries.size()), entries.data(),
                                     values.size() * sizeof(uint32_t), values.data()};

  LUEUR_TRY(module, make_module(shader));
  VkComputePipelineCreateInfo create{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  create.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  create.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  create.stage.module = module;
  create.stage.pName = "main";
  create.stage.pSpecializationInfo = &special;
  create.layout = pipeline->layout;
  const VkResult result =
      vkCreateComputePipelines(device_.handle, cache_, 1, &create, nullptr, &pipeline->handle);
  vkDestroyShaderModule(device_.handle, module, nullptr);
  if (result != VK_SUCCESS) return vulkan_error(result, "making the pipeline " + key);
  device_.name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline->handle), key);
  changed_ = true;
  return (pipelines_[key] = std::move(pipeline)).get();
}

Result<const Pipeline*> PipelineLibrary::graphics(const GraphicsState& state) {
  const std::string key = key_of(state);
  if (const auto found = pipelines_.find(key); found != pipelines_.end())
    return found->second.get();

  auto pipeline = std::make_unique<Pipeline>();
  pipeline->name = key;
  pipeline->bind_point = VK_PIPELINE_BIND_POINT_GRAPHICS;
  std::vector<VkPipelineShaderStageCreateInfo> stages;
  for (const ShaderCode* code : {state.vertex, state.fragment}) {
    if (!code) continue;
    LUEUR_TRY(reflected, reflect(*code));
    merge(pipeline->interface, reflected, key);
    LUEUR_TRY(module, make_module(*code));
    VkPipelineShaderStageCreateInfo stage{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    stage.stage = code == state.vertex ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
    stage.module = module;
    stage.pName = "main";
    stages.push_back(stage);
    pipeline->stages |= stage.stage;
  }
  LUEUR_TRY_VOID(make_layout(*pipeline));

  const VkVertexInputBindingDescription vertex_binding{0, state.vertex_stride_bytes,
                                                       VK_VERTEX_INPUT_RATE_VERTEX};
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const VertexAttribute& a : state.vertex_attributes)
    attributes.push_back({static_cast<uint32_t>(attributes.size()), 0, a.format, a.offset_bytes});
  VkPipelineVertexInputStateCreateInfo vertex_input{
      VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertex_input.vertexBindingDescriptionCount = attributes.empty() ? 0 : 1;
  vertex_input.pVertexBindingDescriptions = &vertex_binding;
  vertex_input.vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes.size());
  vertex_input.pVertexAttributeDescriptions = attributes.data();

  VkPipelineInputAssemblyStateCreateInfo assembly{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  const VkPipelineRasterizationStateCreateInfo raster = raster_state(state);
  const VkPipelineDepthStencilStateCreateInfo depth = depth_state(state);
  VkPipelineMultisampleStateCreateInfo samples{
      VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState write_all{};
  write_all.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                             VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  const std::vector<VkPipelineColorBlendAttachmentState> blends(state.color_formats.size(),
                                                                write_all);
  VkPipelineColorBlendStateCreateInfo blend{
      VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = static_cast<uint32_t>(blends.size());
  blend.pAttachments = blends.data();
  LUEUR_CHECK(state.logic_op == LogicOp::copy || device_.logic_op);
  blend.logicOpEnable = state.logic_op != LogicOp::copy;
  blend.logicOp = to_vk(state.logic_op);
  const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                           VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = static_cast<uint32_t>(std::size(dynamic_states));
  dynamic.pDynamicStates = dynamic_states;

  std::vector<VkFormat> color_formats;
  for (Format format : state.color_formats) color_formats.push_back(to_vk(format));
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = static_cast<uint32_t>(color_formats.size());
  rendering.pColorAttachmentFormats = color_formats.data();
  rendering.depthAttachmentFormat = state.has_depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_UNDEFINED;

  VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  create.pNext = &rendering;
  create.stageCount = static_cast<uint32_t>(stages.size());
  create.pStages = stages.data();
  create.pVertexInputState = &vertex_input;
  create.pInputAssemblyState = &assembly;
  create.pViewportState = &viewport;
  create.pRasterizationState = &raster;
  create.pMultisampleState = &samples;
  create.pDepthStencilState = &depth;
  create.pColorBlendState = &blend;
  create.pDynamicState = &dynamic;
  create.layout = pipeline->layout;
  const VkResult result =
      vkCreateGraphicsPipelines(device_.handle, cache_, 1, &create, nullptr, &pipeline->handle);
  for (const auto& stage : stages) vkDestroyShaderModule(device_.handle, stage.module, nullptr);
  if (result != VK_SUCCESS) return vulkan_error(result, "making the pipeline " + key);
  device_.name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline->handle), key);
  changed_ = true;
  return (pipelines_[key] = std::move(pipeline)).get();
}

}  // namespace lueur::gpu
