// SPDX-License-Identifier: MIT
// Looking into passes from outside: captured images and the scan for what cannot be light.
#include <algorithm>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "base/check.h"
#include "frame/recorder.h"
#include "frame/scan_params.h"
#include "frame/shaders.h"
#include "frame/slot.h"

namespace lueur {
namespace {

constexpr uint32_t kMaxScannedImages = 512;

// True if `text` is like `pattern`, in which each `*` stands for any characters.
bool matches(std::string_view pattern, std::string_view text) {
  size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

// Normals, motion and the numbers of lobes may be negative; light may not.
bool may_be_negative(std::string_view image_name) {
  return image_name.find("normal") != std::string_view::npos ||
         image_name.find("geometry") != std::string_view::npos ||
         image_name.find("motion") != std::string_view::npos ||
         image_name.find("reflectance") != std::string_view::npos;
}

float decode(const std::byte* channel, Format format) {
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, channel, sizeof(T));
    return value;
  };
  switch (format) {
    case Format::r8:
    case Format::rg8:
    case Format::rgba8:
    case Format::rgba8_srgb:
      return static_cast<float>(as(uint8_t{})) / 255.0f;
    case Format::rg16_snorm:
      return std::max(-1.0f, static_cast<float>(as(int16_t{})) / 32767.0f);
    case Format::r16f:
    case Format::rg16f:
    case Format::rgba16f:
      return glm::unpackHalf1x16(as(uint16_t{}));
    case Format::r32ui:
    case Format::rgba32ui:
      return static_cast<float>(as(uint32_t{}));
    case Format::r32f:
    case Format::rgba32f:
    case Format::d32f:
      return as(float{});
  }
  return 0.0f;
}

}  // namespace

void Recorder::inspect(const std::string& pass, const char* image_name, Image image) {
  images_[image.index]->written = true;
  const std::string name = pass + "." + image_name;
  written_images_.push_back(name);
  // Cube maps are seen by the passes that read them; only flat images are captured.
  if (images_[image.index]->texture.info().cube) return;
  for (const std::string& pattern : options.watch)
    if (matches(pattern, name) || matches(pattern, pass)) {
      read_back(name, image);
      break;
    }
  const gpu::FormatInfo& format = gpu::info(image.format);
  if (options.scan && format.is_float) scan(name, image);
}

void Recorder::read_back(const std::string& name, Image image) {
  if (failed() || !image.valid()) return;
  const gpu::FormatInfo& format = gpu::info(image.format);
  auto buffer = gpu::Buffer::create(
      *device_,
      {.name = "read back " + name,
       .bytes = uint64_t{image.extent.width} * image.extent.height * format.bytes_per_pixel,
       .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
       .kind = gpu::MemoryKind::readback});
  if (!buffer.ok()) return fail(buffer.error());
  Barriers barriers;
  use_image(barriers, image, gpu::Use::copy_source, false);
  commands_->barrier(barriers.images, {});
  commands_->copy_to_buffer(
      images_[image.index]->handle(),
      static_cast<VkImageAspectFlags>(format.is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                      : VK_IMAGE_ASPECT_COLOR_BIT),
      buffer->handle(), {.extent = image.extent});
  gpu::AccessState written;
  gpu::advance(written, gpu::info(gpu::Use::copy_target), false, true);
  const auto to_host = gpu::advance(written, gpu::info(gpu::Use::host_read), false, false);
  const gpu::BufferTransition transition{buffer->handle(), *to_host};
  commands_->barrier({}, std::span(&transition, 1));
  slot_->read_backs.push_back({name, image.extent, image.format, std::move(*buffer)});
}

void Recorder::scan(const std::string& name, Image image) {
  constexpr uint64_t kBytes = kMaxScannedImages * sizeof(ScanRow);
  if (slot_->scanned.size() == kMaxScannedImages) return;
  if (!slot_->scan_rows.handle()) {
    auto rows = gpu::Buffer::create(
        *device_, {.name = "scan",
                   .bytes = kBytes,
                   .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                            VK_BUFFER_USAGE_TRANSFER_DST_BIT});
    auto copy = gpu::Buffer::create(*device_, {.name = "scan copy",
                                               .bytes = kBytes,
                                               .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                               .kind = gpu::MemoryKind::readback});
    if (!rows.ok()) return fail(rows.error());
    if (!copy.ok()) return fail(copy.error());
    slot_->scan_rows = std::move(*rows);
    slot_->scan_copy = std::move(*copy);
  }

  const auto use_rows = [&](gpu::Use use) {
    if (auto t = gpu::advance(slot_->scan_state, gpu::info(use), false, false)) {
      const gpu::BufferTransition transition{slot_->scan_rows.handle(), *t};
      commands_->barrier({}, std::span(&transition, 1));
    }
  };
  if (slot_->scanned.empty()) {
    use_rows(gpu::Use::copy_target);
    commands_->fill_buffer(slot_->scan_rows.handle(), 0);
  }
  use_rows(gpu::Use::compute_storage_write);

  auto pipeline = pipelines_->compute(shaders::frame_scan_comp, {});
  if (!pipeline.ok()) return fail(pipeline.error());
  Barriers barriers;
  use_image(barriers, image, gpu::Use::compute_sampled, false);
  commands_->barrier(barriers.images, {});
  gpu::Descriptor rows;
  rows.binding = 1;
  rows.kind = gpu::BindingKind::storage_buffer;
  rows.buffer = slot_->scan_rows.handle();
  const Bound source{"image", image};
  const gpu::Descriptor resources[] = {describe(*(*pipeline)->find("image"), source), rows};
  auto set = slot_->descriptors.make((*pipeline)->set_layouts[0], resources);
  if (!set.ok()) return fail(set.error());
  const ScanParams params{ivec2(image.extent.width, image.extent.height),
                          static_cast<uint32_t>(slot_->scanned.size()),
                          may_be_negative(name) ? 1u : 0u};
  commands_->bind(**pipeline, 0, *set);
  commands_->push(**pipeline, &params, sizeof(params));
  commands_->dispatch(**pipeline, divide_up(image.extent.width, 8),
                      divide_up(image.extent.height, 8), 1);
  slot_->scanned.emplace_back(name, image.extent);
}

std::vector<Pixels> Recorder::read_back_pixels() {
  std::vector<Pixels> all;
  for (const ReadBack& entry : slot_->read_backs) {
    entry.buffer.invalidate();
    const gpu::FormatInfo& format = gpu::info(entry.format);
    Pixels pixels{entry.name, entry.extent, format.channels, {}};
    const size_t count = size_t{entry.extent.width} * entry.extent.height * format.channels;
    const size_t stride = format.bytes_per_pixel / format.channels;
    const std::byte* bytes = entry.buffer.mapped().data();
    pixels.samples.resize(count);
    for (size_t i = 0; i < count; ++i) pixels.samples[i] = decode(bytes + i * stride, entry.format);
    all.push_back(std::move(pixels));
  }
  return all;
}

std::vector<ScanFinding> Recorder::scan_findings() {
  std::vector<ScanFinding> findings;
  if (slot_->scanned.empty()) return findings;
  slot_->scan_copy.invalidate();
  for (size_t i = 0; i < slot_->scanned.size(); ++i) {
    lueur::ScanRow row;
    std::memcpy(&row, slot_->scan_copy.mapped().data() + i * sizeof(row), sizeof(row));
    if (row.inverted_first_pixel == 0) continue;
    const auto& [name, extent] = slot_->scanned[i];
    const uint32_t first = ~row.inverted_first_pixel;
    findings.push_back({name, row.nan_pixels, row.infinite_pixels, row.negative_pixels,
                        first % extent.width, first / extent.width});
  }
  return findings;
}

}  // namespace lueur
