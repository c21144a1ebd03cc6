// SPDX-License-Identifier: MIT
// How one pass is recorded: check it against its shader, wait for what it needs, bind, run.
#include <algorithm>
#include <cstring>

#include "base/check.h"
#include "frame/recorder.h"
#include "frame/slot.h"

namespace lueur {
namespace {

[[noreturn]] void mismatch(const std::string& pass, const gpu::Pipeline& pipeline,
                           const std::string& what) {
  check_failed(__FILE__, __LINE__, "a pass fits its shader",
               "pass " + pass + ", shader " + pipeline.name + ": " + what);
}

constexpr const char* kParamsBlock = "params";

gpu::Use use_of(const gpu::Pipeline& pipeline, const gpu::ShaderBinding& binding) {
  const bool compute = pipeline.bind_point == VK_PIPELINE_BIND_POINT_COMPUTE;
  switch (binding.kind) {
    case gpu::BindingKind::sampled_image:
      return compute ? gpu::Use::compute_sampled : gpu::Use::graphics_sampled;
    case gpu::BindingKind::storage_image:
    case gpu::BindingKind::storage_buffer:
      if (!compute) return gpu::Use::graphics_buffer_read;
      return binding.writes ? gpu::Use::compute_storage_write : gpu::Use::compute_storage_read;
    case gpu::BindingKind::uniform_buffer:
      return compute ? gpu::Use::compute_storage_read : gpu::Use::graphics_buffer_read;
  }
  return gpu::Use::compute_sampled;
}

}  // namespace

void Recorder::use_image(Barriers& barriers, Image image, gpu::Use use, bool discard) {
  PooledImage& entry = *images_[image.index];
  const VkImageAspectFlags aspect =
      gpu::info(image.format).is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  if (auto t = gpu::advance(entry.state, gpu::info(use), true, discard))
    barriers.images.push_back({entry.handle(), aspect, *t});
}

void Recorder::use_buffer(Barriers& barriers, BufferRef buffer, gpu::Use use) {
  FrameBuffer& entry = frame_buffers_[buffer.index];
  if (!entry.state) return;  // The submit makes the CPU's writes visible.
  if (auto t = gpu::advance(*entry.state, gpu::info(use), false, false))
    barriers.buffers.push_back({entry.buffer, *t});
}

gpu::Descriptor Recorder::describe(const gpu::ShaderBinding& binding, const Bound& bound) const {
  gpu::Descriptor d;
  d.binding = binding.binding;
  d.kind = binding.kind;
  if (const Image* image = std::get_if<Image>(&bound.resource)) {
    d.view = images_[image->index]->view();
    d.layout = binding.kind == gpu::BindingKind::sampled_image
                   ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL
                   : VK_IMAGE_LAYOUT_GENERAL;
  } else if (const BufferRef* buffer = std::get_if<BufferRef>(&bound.resource)) {
    const FrameBuffer& entry = frame_buffers_[buffer->index];
    d.buffer = entry.buffer;
    d.offset = entry.offset;
    d.range = entry.bytes;
  } else {
    d.view = std::get<SampledTexture>(bound.resource).texture->view();
    d.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  }
  if (binding.kind == gpu::BindingKind::sampled_image) d.sampler = samplers_->get(bound.sampler);
  return d;
}

VkDescriptorSet Recorder::bind_resources(const std::string& pass, const gpu::Pipeline& pipeline,
                                         const std::vector<Bound>& read,
                                         const std::vector<Bound>& write, const Params& params,
                                         Barriers& barriers) {
  std::vector<Bound> all = read;
  all.insert(all.end(), write.begin(), write.end());

  // Parameters go where the shader wants them.
  if (const gpu::ShaderBinding* block = pipeline.find(kParamsBlock)) {
    if (block->bytes != params.bytes)
      mismatch(pass, pipeline,
               "params has " + std::to_string(params.bytes) + " bytes, the shader's block " +
                   std::to_string(block->bytes));
    all.push_back({kParamsBlock, upload(params.data, params.bytes)});
  }
  if (failed()) return VK_NULL_HANDLE;

  // Match by name, both ways.
  std::vector<gpu::Descriptor> descriptors;
  for (const Bound& bound : all) {
    const gpu::ShaderBinding* binding = pipeline.find(bound.name);
    if (!binding || binding->set != 0)
      mismatch(pass, pipeline, std::string("it has no binding ") + bound.name);
    const bool is_written =
        &bound >= &all[read.size()] && &bound < &all[read.size()] + write.size();
    if (is_written != binding->writes)
      mismatch(pass, pipeline,
               std::string(bound.name) + (binding->writes ? " is written by the shader only"
                                                          : " is readonly in the shader"));
    if (const Image* image = std::get_if<Image>(&bound.resource)) {
      if (!image->valid()) mismatch(pass, pipeline, std::string(bound.name) + " is no image");
      PooledImage& entry = *images_[image->index];
      if (!entry.in_use) mismatch(pass, pipeline, std::string(bound.name) + " was released");
      if (binding->kind == gpu::BindingKind::storage_image &&
          binding->format != gpu::to_vk(image->format))
        mismatch(pass, pipeline,
                 std::string(bound.name) + " is " + std::string(gpu::info(image->format).name) +
                     ", which is not the shader's format");
      if (!is_written && !entry.written)
        mismatch(pass, pipeline, std::string(bound.name) + " is read before it was written");
      const bool discard = is_written && !entry.written;
      use_image(barriers, *image, use_of(pipeline, *binding), discard);
    } else if (const BufferRef* buffer = std::get_if<BufferRef>(&bound.resource)) {
      if (!buffer->valid()) mismatch(pass, pipeline, std::string(bound.name) + " is no buffer");
      if (is_written && frame_buffers_[buffer->index].imported)
        mismatch(pass, pipeline, std::string(bound.name) + " is the engine's, to be read only");
      use_buffer(barriers, *buffer, use_of(pipeline, *binding));
    }
    descriptors.push_back(describe(*binding, bound));
  }
  for (const gpu::ShaderBinding& binding : pipeline.interface.bindings)
    if (binding.set == 0 && std::none_of(all.begin(), all.end(), [&](const Bound& bound) {
          return binding.name == bound.name;
        }))
      mismatch(pass, pipeline, "nothing is bound to " + binding.name);

  auto set = slot_->descriptors.make(pipeline.set_layouts[0], descriptors);
  if (!set.ok()) {
    fail(set.error());
    return VK_NULL_HANDLE;
  }
  return *set;
}

// A timer is a timestamp between two barriers, before and after the pass: without the barriers,
// passes that do not depend on each other would run into each other's time, and some drivers would
// take the timestamps of several passes at once.
void Recorder::begin_pass(const std::string& pass, const Barriers& barriers) {
  commands_->begin_label(pass);
  commands_->barrier(barriers.images, barriers.buffers);
  if (slot_->timing == Timers::off) return;
  auto& timed = slot_->timed_passes;
  if (slot_->timing == Timers::passes) {
    timed.emplace_back(pass, slot_->timers.mark(*commands_));
    return;
  }
  // The mark between two owners ends one and begins the other; finish() sets the last.
  const std::string together = pass.substr(0, pass.rfind('.')) + ".*";
  if (timed.empty() || timed.back().first != together)
    timed.emplace_back(together, slot_->timers.mark(*commands_));
}

void Recorder::end_pass() {
  if (slot_->timing == Timers::passes) slot_->timers.mark(*commands_);
  commands_->end_label();
}

void Recorder::dispatch(const std::string& pass, const Dispatch& info) {
  if (failed()) return;
  auto found = pipelines_->compute(info.shader, info.constants);
  if (!found.ok()) return fail(found.error());
  const gpu::Pipeline& pipeline = **found;

  const bool by_push = pipeline.interface.push_constant_bytes > 0;
  if (by_push && pipeline.interface.push_constant_bytes != info.params.bytes)
    mismatch(pass, pipeline,
             "params has " + std::to_string(info.params.bytes) + " bytes, the push constants " +
                 std::to_string(pipeline.interface.push_constant_bytes));
  Barriers barriers;
  const VkDescriptorSet set =
      bind_resources(pass, pipeline, info.read, info.write, info.params, barriers);
  if (failed()) return;
  if (info.groups.valid()) use_buffer(barriers, info.groups, gpu::Use::dispatch_arguments);

  begin_pass(pass, barriers);
  commands_->bind(pipeline, 0, set);
  if (by_push)
    commands_->push(pipeline, info.params.data, static_cast<uint32_t>(info.params.bytes));
  const uint32_t* group = pipeline.interface.workgroup_size;
  if (info.groups.valid()) {
    const FrameBuffer& groups = frame_buffers_[info.groups.index];
    commands_->dispatch_indirect(pipeline, groups.buffer, groups.offset);
  } else {
    commands_->dispatch(pipeline, divide_up(info.over.width, group[0]),
                        divide_up(info.over.height, group[1]), 1);
  }
  end_pass();

  for (const Bound& bound : info.write)
    if (const Image* image = std::get_if<Image>(&bound.resource)) inspect(pass, bound.name, *image);
}

void Recorder::draw(const std::string& pass, const Draw& info) {
  if (failed()) return;
  gpu::GraphicsState state = info.state;
  for (const DrawTarget& target : info.color) {
    if (!target.image.valid()) return;
    state.color_formats.push_back(target.image.format);
  }
  state.has_depth = info.depth.has_value();
  auto found = pipelines_->graphics(state);
  if (!found.ok()) return fail(found.error());
  const gpu::Pipeline& pipeline = **found;

  Barriers barriers;
  const VkDescriptorSet set = bind_resources(pass, pipeline, info.read, {}, info.params, barriers);
  if (failed()) return;
  std::vector<gpu::ColorTarget> colors;
  const auto layer_view = [&](const DrawTarget& target) {
    const PooledImage& entry = *images_[target.image.index];
    return entry.external.image ? entry.external.view : entry.texture.layer_view(target.layer);
  };
  for (const DrawTarget& target : info.color) {
    use_image(barriers, target.image, gpu::Use::color_attachment,
              !images_[target.image.index]->written);
    if (target.keep && !images_[target.image.index]->written)
      mismatch(pass, pipeline, std::string(target.name) + " is kept before it was written");
    colors.push_back({layer_view(target), target.clear, target.keep});
  }
  gpu::DepthTarget depth;
  Extent extent;
  if (info.depth) {
    use_image(barriers, info.depth->image, gpu::Use::depth_attachment,
              !images_[info.depth->image.index]->written);
    depth = {layer_view(*info.depth), info.depth->clear[0]};
    extent = info.depth->image.extent;
  }
  if (!info.color.empty()) extent = info.color[0].image.extent;

  begin_pass(pass, barriers);
  commands_->begin_rendering(extent, colors, depth);
  commands_->bind_pipeline(pipeline);
  commands_->front_face(true);
  commands_->cull_back_faces(true);
  commands_->bind(pipeline, 0, set);
  DrawList list(*this, pipeline);
  info.record(list);
  commands_->end_rendering();
  end_pass();

  for (const DrawTarget& target : info.color) inspect(pass, target.name, target.image);
  if (info.depth) inspect(pass, info.depth->name, info.depth->image);
}

MaterialSet Recorder::material_set(std::vector<Bound> bindings) {
  material_sets_.push_back(std::move(bindings));
  return {static_cast<uint32_t>(material_sets_.size() - 1)};
}

void DrawList::material(MaterialSet set) {
  // Depth alone needs no textures.
  const auto& all = pipeline_.interface.bindings;
  if (std::none_of(all.begin(), all.end(), [](const auto& binding) { return binding.set == 1; }))
    return;
  const auto key = std::pair(&pipeline_, set.index);
  auto found = recorder_.material_descriptor_sets_.find(key);
  if (found == recorder_.material_descriptor_sets_.end()) {
    std::vector<gpu::Descriptor> descriptors;
    for (const gpu::ShaderBinding& binding : pipeline_.interface.bindings) {
      if (binding.set != 1) continue;
      const auto& bounds = recorder_.material_sets_[set.index];
      const auto bound = std::find_if(bounds.begin(), bounds.end(),
                                      [&](const Bound& b) { return binding.name == b.name; });
      if (bound == bounds.end())
        mismatch("material", pipeline_, "the material has nothing for " + binding.name);
      descriptors.push_back(recorder_.describe(binding, *bound));
    }
    auto made = recorder_.material_descriptors_->make(pipeline_.set_layouts[1], descriptors);
    if (!made.ok()) return recorder_.fail(made.error());
    found = recorder_.material_descriptor_sets_.emplace(key, *made).first;
  }
  recorder_.commands_->bind(pipeline_, 1, found->second);
}

void DrawList::geometry(const gpu::Buffer& vertices, const gpu::Buffer& indices) {
  recorder_.commands_->bind_geometry(vertices.handle(), indices.handle());
}

void DrawList::front_face(bool counter_clockwise) {
  recorder_.commands_->front_face(counter_clockwise);
}

void DrawList::cull_back_faces(bool on) {
  recorder_.commands_->cull_back_faces(on);
}

void DrawList::push(const Params& params) {
  if (params.bytes != pipeline_.interface.push_constant_bytes)
    mismatch("draw", pipeline_,
             "push has " + std::to_string(params.bytes) + " bytes, the push constants " +
                 std::to_string(pipeline_.interface.push_constant_bytes));
  recorder_.commands_->push(pipeline_, params.data, static_cast<uint32_t>(params.bytes));
}

void DrawList::indexed(uint32_t index_count, uint32_t first_index, int32_t vertex_offset,
                       uint32_t instance_count, uint32_t first_instance) {
  recorder_.commands_->draw_indexed(index_count, first_index, vertex_offset, instance_count,
                                    first_instance);
}

void DrawList::vertices(uint32_t vertex_count) {
  recorder_.commands_->draw(vertex_count);
}

}  // namespace lueur
