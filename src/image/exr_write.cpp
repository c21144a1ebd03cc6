// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>

#include "base/check.h"
#include "base/file.h"
#include "base/try.h"
#include "image/exr.h"
#include "image/half.h"

namespace lueur {
namespace {

// Lets the library write to memory. It goes back to fill in the offsets of the blocks.
class MemoryOutput final : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}

  void write(const char* source, int count) override {
    const size_t end = position_ + static_cast<size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::copy_n(reinterpret_cast<const uint8_t*>(source), count, bytes_.data() + position_);
    position_ = end;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }

  std::span<const uint8_t> bytes() const { return bytes_; }

 private:
  std::vector<uint8_t> bytes_;
  size_t position_ = 0;
};

std::string component_name(const ImageLayer& layer, uint32_t channel) {
  std::string_view names;
  if (layer.name == "depth" && layer.image.channels == 1)
    names = "Z";
  else if (layer.name == "normal" && layer.image.channels == 3)
    names = "XYZ";
  else if (layer.image.channels == 3 || layer.image.channels == 4)
    names = "RGBA";
  else if (layer.name.empty() && layer.image.channels == 1)
    names = "Y";
  return names.empty() ? std::to_string(channel) : std::string(1, names[channel]);
}

std::string channel_name(const ImageLayer& layer, uint32_t channel) {
  const std::string component = component_name(layer, channel);
  return layer.name.empty() ? component : layer.name + "." + component;
}

std::vector<uint16_t> halves_of(const ImageF& image) {
  std::vector<uint16_t> halves(image.samples.size());
  std::ranges::transform(image.samples, halves.begin(), [](float value) {
    return half_from_float(std::isfinite(value) ? std::clamp(value, -kLargestHalf, kLargestHalf)
                                                : value);
  });
  return halves;
}

// Adds the channels of one layer to the header and to the frame buffer. `samples` has the layout of
// the layer's image and elements of `type`; it must outlive the frame buffer.
void add_layer(const ImageLayer& layer, Imf::PixelType type, const void* samples,
               Imf::Header& header, Imf::FrameBuffer& frame_buffer) {
  const size_t sample_bytes = type == Imf::HALF ? sizeof(uint16_t) : sizeof(float);
  const size_t pixel_bytes = sample_bytes * layer.image.channels;
  for (uint32_t c = 0; c < layer.image.channels; ++c) {
    const std::string name = channel_name(layer, c);
    header.channels().insert(name, Imf::Channel(type));
    frame_buffer.insert(
        name, Imf::Slice::Make(type, static_cast<const char*>(samples) + c * sample_bytes,
                               header.dataWindow(), pixel_bytes, pixel_bytes * layer.image.width));
  }
}

void encode(std::span<const ImageLayer> layers, const ExrOptions& options, MemoryOutput& output) {
  const ImageF& first = layers.front().image;
  Imf::Header header(static_cast<int>(first.width), static_cast<int>(first.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, value] : options.attributes)
    header.insert(name, Imf::StringAttribute(value));

  Imf::FrameBuffer frame_buffer;
  std::vector<std::vector<uint16_t>> halves(layers.size());
  for (size_t i = 0; i < layers.size(); ++i) {
    if (options.float_layers.contains(layers[i].name)) {
      add_layer(layers[i], Imf::FLOAT, layers[i].image.samples.data(), header, frame_buffer);
    } else {
      halves[i] = halves_of(layers[i].image);
      add_layer(layers[i], Imf::HALF, halves[i].data(), header, frame_buffer);
    }
  }

  // The destructor of the file writes the offsets of the blocks.
  Imf::OutputFile file(output, header);
  file.setFrameBuffer(frame_buffer);
  file.writePixels(static_cast<int>(first.height));
}

Result<void> check_limits(std::span<const ImageLayer> layers, const std::string& name) {
  LUEUR_CHECK(!layers.empty());
  const ImageF& first = layers.front().image;
  uint64_t channels = 0;
  std::set<std::string> names;
  for (const ImageLayer& layer : layers) {
    const ImageF& image = layer.image;
    LUEUR_CHECK_OP(image.width, ==, first.width);
    LUEUR_CHECK_OP(image.height, ==, first.height);
    LUEUR_CHECK_OP(image.samples.size(), ==, size_t{image.width} * image.height * image.channels);
    LUEUR_CHECK(names.insert(layer.name).second);
    channels += image.channels;
  }
  const bool fits = first.width >= 1 && first.width <= kMaxExrSide && first.height >= 1 &&
                    first.height <= kMaxExrSide && channels >= 1 && channels <= kMaxExrChannels &&
                    channels * first.width * first.height <= kMaxExrSamples;
  if (fits) return {};
  return Error{ErrorKind::output, name + ": " + std::to_string(first.width) + "x" +
                                      std::to_string(first.height) + " with " +
                                      std::to_string(channels) +
                                      " channels is too large for an EXR; write fewer layers or "
                                      "a smaller picture"};
}

}  // namespace

Result<void> write_exr(const std::filesystem::path& path, std::span<const ImageLayer> layers,
                       const ExrOptions& options) {
  LUEUR_TRY_VOID(check_limits(layers, path.string()));
  MemoryOutput output;
  try {
    encode(layers, options, output);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, path.string() + ": memory ran out; write a smaller picture"};
  } catch (const std::exception& exception) {
    return Error{ErrorKind::output, path.string() + ": cannot be encoded: " + exception.what()};
  }
  return write_file(path, output.bytes());
}

}  // namespace lueur
