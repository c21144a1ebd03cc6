// SPDX-License-Identifier: MIT
// The recorder's resources and the life of a frame. Passes are in passes.cpp, what looks into them
// in inspect.cpp.
#include "frame/recorder.h"

#include <algorithm>
#include <cstring>

#include "base/check.h"
#include "base/try.h"
#include "frame/scan_params.h"
#include "frame/slot.h"

namespace lueur {
namespace {

constexpr uint64_t kChunkBytes = uint64_t{1} << 20;

}  // namespace

Recorder::Recorder(const ContextInfo& info) : info_(info) {}

Result<std::unique_ptr<Recorder>> Recorder::create(const ContextInfo& info) {
  LUEUR_TRY(device, gpu::Device::create(info));
  std::unique_ptr<Recorder> recorder(new Recorder(info));
  recorder->device_ = std::move(device);
  recorder->pipelines_ =
      std::make_unique<gpu::PipelineLibrary>(*recorder->device_, info.pipeline_cache);
  recorder->samplers_ = std::make_unique<gpu::SamplerLibrary>(*recorder->device_);
  recorder->material_descriptors_ = std::make_unique<gpu::DescriptorArena>(*recorder->device_);
  for (uint32_t i = 0; i < std::max(info.frames_in_flight, 1u); ++i)
    recorder->slots_.push_back(std::make_unique<Slot>(*recorder->device_));
  return recorder;
}

Recorder::~Recorder() = default;

void Recorder::begin(VkCommandBuffer command_buffer) {
  LUEUR_CHECK(!commands_.has_value());
  ++frame_;
  slot_ = slots_[frame_ % slots_.size()].get();
  commands_.emplace(command_buffer, device_->debug_names);
  error_.reset();
  history_ = &histories_[options.history_of];
  ++history_->frame;
  slot_->descriptors.reset();
  for (Slot::Chunk& chunk : slot_->chunks) chunk.used = 0;
  slot_->read_backs.clear();
  slot_->scanned.clear();
  slot_->timed_passes.clear();
  slot_->timing = info_.timers;
  if (info_.timers != Timers::off && !slot_->timers.begin(*commands_)) slot_->timing = Timers::off;
  written_images_.clear();
  for (auto& image : images_) image->written = false;
}

Result<void> Recorder::finish() {
  LUEUR_CHECK(commands_.has_value());
  if (slot_->timing == Timers::together && !slot_->timed_passes.empty())
    slot_->timers.mark(*commands_);
  // Copy the scan's counters, then give every imported image back as it came.
  Barriers barriers;
  if (!error_ && !slot_->scanned.empty()) {
    const gpu::UseInfo copy = gpu::info(gpu::Use::copy_source);
    if (auto t = gpu::advance(slot_->scan_state, copy, false, false))
      barriers.buffers.push_back({slot_->scan_rows.handle(), *t});
  }
  for (auto& image : images_) {
    if (!image->external.image) continue;
    const ExternalImage& external = image->external;
    const gpu::UseInfo back{external.last_stage, external.last_access, external.layout, true};
    if (external.layout != VK_IMAGE_LAYOUT_UNDEFINED)
      if (auto t = gpu::advance(image->state, back, true, false))
        barriers.images.push_back(
            {external.image,
             static_cast<VkImageAspectFlags>(gpu::info(external.format).is_depth
                                                 ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                 : VK_IMAGE_ASPECT_COLOR_BIT),
             *t});
  }
  commands_->barrier(barriers.images, barriers.buffers);
  if (!error_ && !slot_->scanned.empty())
    commands_->copy_buffer(slot_->scan_rows.handle(), 0, slot_->scan_copy.handle(), 0,
                           slot_->scanned.size() * sizeof(lueur::ScanRow));

  // What a failed frame recorded may never run: nothing of it may be taken for the past.
  if (error_) forget_history();
  // Imported handles end with the frame; pooled images stay, free for the next one.
  for (auto& image : images_) {
    if (image->external.image) image->external = {};
    if (!image->history) image->in_use = false;
  }
  for (auto& buffer : buffers_) buffer->in_use = false;
  frame_buffers_.clear();
  imported_buffers_.clear();
  trim_pool();
  for (Slot::Chunk& chunk : slot_->chunks) chunk.buffer.flush();
  commands_.reset();
  if (error_) return *error_;
  return {};
}

// Frees what has not been used for a while. Indices of other images stay as they are.
void Recorder::trim_pool() {
  const uint64_t idle_frames = std::max<uint64_t>(options.idle_frames, slots_.size() - 1);
  for (auto& image : images_)
    if (image->texture.handle() && !image->in_use && !image->history &&
        frame_ - image->last_frame > idle_frames)
      *image = PooledImage{};
  std::erase_if(buffers_, [&](const auto& b) { return frame_ - b->last_frame > idle_frames; });
}

Image Recorder::handle_of(uint32_t index) const {
  const PooledImage& image = *images_[index];
  if (image.external.image) return {index, image.external.extent, image.external.format};
  return {index, image.texture.info().extent, image.texture.info().format};
}

Image Recorder::pooled(const char* name, Extent extent, Format format, bool cube, bool history) {
  if (failed()) return {};
  LUEUR_CHECK(commands_.has_value());
  uint32_t vacant = Image::kInvalid;
  for (uint32_t i = 0; i < images_.size(); ++i) {
    PooledImage& candidate = *images_[i];
    if (candidate.in_use || candidate.history || candidate.external.image) continue;
    if (!candidate.texture.handle()) {
      vacant = i;
      continue;
    }
    const gpu::TextureInfo& has = candidate.texture.info();
    if (history || has.extent != extent || has.format != format || has.cube != cube) continue;
    candidate.in_use = true;
    candidate.written = false;
    candidate.last_frame = frame_;
    candidate.name = name;
    device_->name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(candidate.handle()), name);
    return handle_of(i);
  }

  auto texture = gpu::Texture::create(*device_, {.name = name,
                                                 .extent = extent,
                                                 .format = format,
                                                 .usage = gpu::general_usage(format),
                                                 .layers = cube ? 6u : 1u,
                                                 .cube = cube});
  if (!texture.ok()) {
    fail(texture.error());
    return {};
  }
  if (vacant == Image::kInvalid) {
    vacant = static_cast<uint32_t>(images_.size());
    images_.push_back(std::make_unique<PooledImage>());
  }
  PooledImage& image = *images_[vacant];
  image.texture = std::move(*texture);
  image.state = {};
  image.name = name;
  image.in_use = true;
  image.history = history;
  image.last_frame = frame_;
  return handle_of(vacant);
}

Image Recorder::image(const char* name, Extent extent, Format format) {
  return pooled(name, extent, format, false, false);
}

Image Recorder::cube(const char* name, uint32_t side, Format format) {
  return pooled(name, {side, side}, format, true, false);
}

void Recorder::release(Image image) {
  if (!image.valid()) return;
  PooledImage& entry = *images_[image.index];
  LUEUR_CHECK(entry.in_use && !entry.history && !entry.external.image);
  entry.in_use = false;
}

HistoryImage Recorder::history(const std::string& name, Extent extent, Format format) {
  if (failed()) return {};
  const uint64_t now = history_->frame;
  HistoryPair& pair = history_->pairs[name];
  const bool known = pair.last_frame != 0;
  const bool same = known && handle_of(pair.images[0]).extent == extent &&
                    handle_of(pair.images[0]).format == format;
  if (!same) {
    for (uint32_t& index : pair.images) {
      if (known) images_[index]->history = images_[index]->in_use = false;
      const Image fresh = pooled(name.c_str(), extent, format, false, true);
      if (!fresh.valid()) return {};
      index = fresh.index;
    }
    pair.last_frame = 0;
  }
  // The first call of a frame turns the pair over; later ones get the same answer.
  if (pair.last_frame != now) {
    pair.valid = pair.last_frame != 0 && pair.last_frame + 1 == now;
    pair.current = 1 - pair.current;
    pair.last_frame = now;
    for (uint32_t index : pair.images) images_[index]->last_frame = frame_;
    // Last frame's content counts as written, so that it may be read now.
    images_[pair.images[1 - pair.current]]->written = pair.valid;
  }
  return {handle_of(pair.images[1 - pair.current]), handle_of(pair.images[pair.current]),
          pair.valid};
}

void Recorder::forget_history() {
  for (auto& image : images_)
    if (image->history) image->history = image->in_use = false;
  for (auto& [name, history] : histories_) history.pairs.clear();
}

Image Recorder::import(const ExternalImage& external) {
  if (failed()) return {};
  uint32_t index = 0;
  while (index < images_.size() && (images_[index]->texture.handle() ||
                                    images_[index]->external.image || images_[index]->in_use))
    ++index;
  if (index == images_.size()) images_.push_back(std::make_unique<PooledImage>());
  PooledImage& image = *images_[index];
  image = PooledImage{};
  image.external = external;
  image.name = "imported";
  image.in_use = true;
  image.written = true;
  image.state.layout = external.layout;
  image.state.write_stage = external.last_stage;
  image.state.write_access = external.last_access;
  return handle_of(index);
}

void Recorder::copy(Image from, Image to) {
  if (failed()) return;
  LUEUR_CHECK(from.valid() && to.valid());
  LUEUR_CHECK(from.extent == to.extent && from.format == to.format);
  LUEUR_CHECK(images_[from.index]->written);
  Barriers barriers;
  use_image(barriers, from, gpu::Use::copy_source, false);
  use_image(barriers, to, gpu::Use::copy_target, true);
  commands_->barrier(barriers.images, {});
  commands_->copy_image(images_[from.index]->handle(), images_[to.index]->handle(), from.extent,
                        gpu::info(from.format).is_depth);
  images_[to.index]->written = true;
}

BufferRef Recorder::buffer(const char* name, uint64_t bytes) {
  if (failed()) return {};
  for (auto& pooled_buffer : buffers_) {
    if (pooled_buffer->in_use || pooled_buffer->buffer.bytes() != bytes) continue;
    pooled_buffer->in_use = true;
    pooled_buffer->last_frame = frame_;
    frame_buffers_.push_back({pooled_buffer->buffer.handle(), 0, bytes, &pooled_buffer->state});
    return {static_cast<uint32_t>(frame_buffers_.size() - 1)};
  }
  auto created = gpu::Buffer::create(
      *device_, {.name = name,
                 .bytes = bytes,
                 .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                          VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT});
  if (!created.ok()) {
    fail(created.error());
    return {};
  }
  buffers_.push_back(std::make_unique<PooledBuffer>());
  PooledBuffer& entry = *buffers_.back();
  entry.buffer = std::move(*created);
  entry.in_use = true;
  entry.last_frame = frame_;
  frame_buffers_.push_back({entry.buffer.handle(), 0, bytes, &entry.state});
  return {static_cast<uint32_t>(frame_buffers_.size() - 1)};
}

BufferRef Recorder::import(const ExternalBuffer& external) {
  if (failed()) return {};
  LUEUR_CHECK(commands_.has_value());
  gpu::AccessState& state = *imported_buffers_.emplace_back(std::make_unique<gpu::AccessState>());
  state.write_stage = external.last_stage;
  state.write_access = external.last_access;
  frame_buffers_.push_back({external.buffer, 0, external.bytes, &state, true});
  return {static_cast<uint32_t>(frame_buffers_.size() - 1)};
}

BufferRef Recorder::upload(const void* data, uint64_t bytes) {
  if (failed()) return {};
  LUEUR_CHECK(commands_.has_value());
  const auto& limits = device_->properties.limits;
  const uint64_t alignment = std::max({limits.minStorageBufferOffsetAlignment,
                                       limits.minUniformBufferOffsetAlignment, VkDeviceSize{16}});
  const uint64_t wanted = std::max<uint64_t>(bytes, 16);
  auto chunk = std::find_if(slot_->chunks.begin(), slot_->chunks.end(),
                            [&](const auto& c) { return c.used + wanted <= c.buffer.bytes(); });
  if (chunk == slot_->chunks.end()) {
    auto created = gpu::Buffer::create(
        *device_, {.name = "uploads",
                   .bytes = std::max(wanted, kChunkBytes),
                   .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                   .kind = gpu::MemoryKind::upload});
    if (!created.ok()) {
      fail(created.error());
      return {};
    }
    slot_->chunks.push_back({std::move(*created), 0});
    chunk = slot_->chunks.end() - 1;
  }
  if (bytes > 0) std::memcpy(chunk->buffer.mapped().data() + chunk->used, data, bytes);
  frame_buffers_.push_back({chunk->buffer.handle(), chunk->used, wanted, nullptr});
  chunk->used += (wanted + alignment - 1) / alignment * alignment;
  return {static_cast<uint32_t>(frame_buffers_.size() - 1)};
}

Image Recorder::upload_image(const char* name, Extent extent, Format format, const void* pixels) {
  const Image target = image(name, extent, format);
  const BufferRef bytes =
      upload(pixels, uint64_t{extent.width} * extent.height * gpu::info(format).bytes_per_pixel);
  if (failed()) return {};
  Barriers barriers;
  use_image(barriers, target, gpu::Use::copy_target, true);
  commands_->barrier(barriers.images, {});
  const gpu::CopyRegion region{.buffer_offset = frame_buffers_[bytes.index].offset,
                               .extent = extent};
  PooledImage& entry = *images_[target.index];
  commands_->copy_to_image(frame_buffers_[bytes.index].buffer, entry.handle(),
                           std::span(&region, 1));
  entry.written = true;
  return target;
}

std::vector<PassTime> Recorder::pass_times() const {
  if (!slot_ || slot_->timing == Timers::off) return {};
  const std::vector<double> ms = slot_->timers.read();
  std::vector<PassTime> times;
  for (const auto& [name, query] : slot_->timed_passes)
    if (query + 1 < ms.size()) times.push_back({name, ms[query + 1] - ms[query]});
  return times;
}

}  // namespace lueur
