// SPDX-License-Identifier: MIT
#include <spirv_cross_c.h>

#include <memory>

#include "gpu/shader.h"

namespace lueur::gpu {
namespace {

using Compiler = spvc_compiler;

VkFormat storage_format(SpvImageFormat format) {
  switch (format) {
    case SpvImageFormatR8:
      return VK_FORMAT_R8_UNORM;
    case SpvImageFormatRg8:
      return VK_FORMAT_R8G8_UNORM;
    case SpvImageFormatRgba8:
      return VK_FORMAT_R8G8B8A8_UNORM;
    case SpvImageFormatRg16Snorm:
      return VK_FORMAT_R16G16_SNORM;
    case SpvImageFormatR16f:
      return VK_FORMAT_R16_SFLOAT;
    case SpvImageFormatRg16f:
      return VK_FORMAT_R16G16_SFLOAT;
    case SpvImageFormatRgba16f:
      return VK_FORMAT_R16G16B16A16_SFLOAT;
    case SpvImageFormatR32f:
      return VK_FORMAT_R32_SFLOAT;
    case SpvImageFormatRgba32f:
      return VK_FORMAT_R32G32B32A32_SFLOAT;
    case SpvImageFormatR32ui:
      return VK_FORMAT_R32_UINT;
    case SpvImageFormatRgba32ui:
      return VK_FORMAT_R32G32B32A32_UINT;
    default:
      return VK_FORMAT_UNDEFINED;
  }
}

std::vector<ShaderMember> members_of(Compiler compiler, spvc_type_id type_id) {
  const spvc_type type = spvc_compiler_get_type_handle(compiler, type_id);
  const spvc_type_id base = spvc_type_get_base_type_id(type);
  std::vector<ShaderMember> members;
  for (unsigned i = 0; i < spvc_type_get_num_member_types(type); ++i) {
    ShaderMember member;
    member.name = spvc_compiler_get_member_name(compiler, base, i);
    unsigned offset = 0;
    spvc_compiler_type_struct_member_offset(compiler, type, i, &offset);
    member.offset = offset;
    size_t bytes = 0;
    spvc_compiler_get_declared_struct_member_size(compiler, type, i, &bytes);
    member.bytes = static_cast<uint32_t>(bytes);
    members.push_back(member);
  }
  return members;
}

// A block that is one array of structures is described by the structure: that is what C++ shares.
std::vector<ShaderMember> block_members(Compiler compiler, spvc_type_id type_id) {
  const spvc_type type = spvc_compiler_get_type_handle(compiler, type_id);
  if (spvc_type_get_num_member_types(type) == 1) {
    const spvc_type_id member_id = spvc_type_get_member_type(type, 0);
    const spvc_type member = spvc_compiler_get_type_handle(compiler, member_id);
    if (spvc_type_get_basetype(member) == SPVC_BASETYPE_STRUCT)
      return members_of(compiler, spvc_type_get_base_type_id(member));
  }
  return members_of(compiler, type_id);
}

uint32_t struct_bytes(Compiler compiler, spvc_type_id type_id) {
  size_t bytes = 0;
  spvc_compiler_get_declared_struct_size(compiler, spvc_compiler_get_type_handle(compiler, type_id),
                                         &bytes);
  return static_cast<uint32_t>(bytes);
}

void add_bindings(Compiler compiler, spvc_resources resources, spvc_resource_type type,
                  BindingKind kind, ShaderInterface& out) {
  const spvc_reflected_resource* list = nullptr;
  size_t count = 0;
  spvc_resources_get_resource_list_for_type(resources, type, &list, &count);
  for (size_t i = 0; i < count; ++i) {
    const spvc_reflected_resource& resource = list[i];
    ShaderBinding binding;
    binding.name = spvc_compiler_get_name(compiler, resource.id);
    if (binding.name.empty()) binding.name = resource.name;
    binding.set = spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationDescriptorSet);
    binding.binding = spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationBinding);
    binding.kind = kind;
    if (kind == BindingKind::storage_image) {
      const spvc_type image = spvc_compiler_get_type_handle(compiler, resource.type_id);
      binding.format = storage_format(spvc_type_get_image_storage_format(image));
      binding.writes =
          !spvc_compiler_has_decoration(compiler, resource.id, SpvDecorationNonWritable);
    }
    if (kind == BindingKind::storage_buffer) {
      const SpvDecoration* decorations = nullptr;
      size_t decoration_count = 0;
      binding.writes = true;
      spvc_compiler_get_buffer_block_decorations(compiler, resource.id, &decorations,
                                                 &decoration_count);
      for (size_t d = 0; d < decoration_count; ++d)
        if (decorations[d] == SpvDecorationNonWritable) binding.writes = false;
    }
    if (kind == BindingKind::storage_buffer || kind == BindingKind::uniform_buffer) {
      binding.bytes = struct_bytes(compiler, resource.base_type_id);
      out.blocks.emplace_back(binding.name, block_members(compiler, resource.base_type_id));
    }
    out.bindings.push_back(binding);
  }
}

}  // namespace

Result<ShaderInterface> reflect(const ShaderCode& code) {
  spvc_context raw_context = nullptr;
  spvc_context_create(&raw_context);
  const std::unique_ptr<spvc_context_s, void (*)(spvc_context)> context(raw_context,
                                                                        spvc_context_destroy);
  spvc_parsed_ir ir = nullptr;
  Compiler compiler = nullptr;
  spvc_resources resources = nullptr;
  if (spvc_context_parse_spirv(context.get(), code.words.data(), code.words.size(), &ir) !=
          SPVC_SUCCESS ||
      spvc_context_create_compiler(context.get(), SPVC_BACKEND_NONE, ir,
                                   SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler) != SPVC_SUCCESS ||
      spvc_compiler_create_shader_resources(compiler, &resources) != SPVC_SUCCESS)
    return Error{ErrorKind::device, "shader " + std::string(code.name) + " cannot be reflected: " +
                                        spvc_context_get_last_error_string(context.get())};

  ShaderInterface out;
  add_bindings(compiler, resources, SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, BindingKind::sampled_image,
               out);
  add_bindings(compiler, resources, SPVC_RESOURCE_TYPE_STORAGE_IMAGE, BindingKind::storage_image,
               out);
  add_bindings(compiler, resources, SPVC_RESOURCE_TYPE_STORAGE_BUFFER, BindingKind::storage_buffer,
               out);
  add_bindings(compiler, resources, SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, BindingKind::uniform_buffer,
               out);

  const spvc_reflected_resource* push = nullptr;
  size_t push_count = 0;
  spvc_resources_get_resource_list_for_type(resources, SPVC_RESOURCE_TYPE_PUSH_CONSTANT, &push,
                                            &push_count);
  if (push_count == 1) {
    out.push_constant_bytes = struct_bytes(compiler, push[0].base_type_id);
    out.push_constants = block_members(compiler, push[0].base_type_id);
  }

  for (unsigned i = 0; i < 3; ++i)
    out.workgroup_size[i] =
        spvc_compiler_get_execution_mode_argument_by_index(compiler, SpvExecutionModeLocalSize, i);

  const spvc_specialization_constant* constants = nullptr;
  size_t constant_count = 0;
  spvc_compiler_get_specialization_constants(compiler, &constants, &constant_count);
  for (size_t i = 0; i < constant_count; ++i)
    out.specialization_constants.emplace_back(constants[i].constant_id,
                                              spvc_compiler_get_name(compiler, constants[i].id));
  return out;
}

}  // namespace lueur::gpu
