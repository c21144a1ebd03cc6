// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <tuple>

#include "base/file.h"
#include "base/try.h"
#include "image/exr.h"
#include "image/exr_header.h"

namespace lueur {
namespace {

constexpr uint64_t kMaxFileBytes = uint64_t{1} << 30;

// Lets the library read from memory. Throws, as it expects, past the end.
class MemoryInput final : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const uint8_t> bytes) : Imf::IStream("data"), bytes_(bytes) {}

  bool read(char* destination, int count) override {
    if (count < 0 || position_ > bytes_.size() ||
        static_cast<size_t>(count) > bytes_.size() - position_)
      throw std::runtime_error("it is cut short");
    std::memcpy(destination, bytes_.data() + position_, static_cast<size_t>(count));
    position_ += static_cast<size_t>(count);
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override { position_ = position; }

 private:
  std::span<const uint8_t> bytes_;
  uint64_t position_ = 0;
};

// A channel "indirect.R" is the component "R" of the layer "indirect".
struct Channel {
  std::string name;
  std::string layer;
  std::string component;
};

Channel split_name(const std::string& name) {
  const size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {name, "", name};
  return {name, name.substr(0, dot), name.substr(dot + 1)};
}

// Where a component stands among those of its layer.
std::tuple<size_t, size_t, std::string> place(const std::string& component) {
  constexpr std::string_view kKnown = "RGBAXYZ";
  if (component.size() == 1 && kKnown.find(component[0]) != std::string_view::npos)
    return {0, kKnown.find(component[0]), ""};
  const bool number = component.find_first_not_of("0123456789") == std::string::npos;
  if (number && !component.empty()) return {1, component.size(), component};
  return {2, 0, component};
}

std::vector<Channel> ordered_channels(const Imf::ChannelList& list) {
  std::vector<Channel> channels;
  for (auto channel = list.begin(); channel != list.end(); ++channel)
    channels.push_back(split_name(channel.name()));
  std::ranges::sort(channels, [](const Channel& a, const Channel& b) {
    return a.layer != b.layer ? a.layer < b.layer : place(a.component) < place(b.component);
  });
  return channels;
}

std::vector<ImageLayer> read_layers(Imf::InputFile& file, const ExrHeader& header) {
  // Make each layer, with the number of channels that it has.
  const std::vector<Channel> channels = ordered_channels(file.header().channels());
  std::vector<ImageLayer> layers;
  for (size_t first = 0; first < channels.size();) {
    size_t last = first;
    while (last < channels.size() && channels[last].layer == channels[first].layer) ++last;
    layers.push_back({channels[first].layer,
                      ImageF(header.width, header.height, static_cast<uint32_t>(last - first))});
    first = last;
  }

  // Point the library at the samples of every channel; it converts half and integer to float.
  Imf::FrameBuffer frame_buffer;
  size_t next = 0;
  for (ImageLayer& layer : layers) {
    const size_t pixel_bytes = layer.image.channels * sizeof(float);
    for (uint32_t c = 0; c < layer.image.channels; ++c)
      frame_buffer.insert(
          channels[next++].name,
          Imf::Slice::Make(Imf::FLOAT, layer.image.samples.data() + c, file.header().dataWindow(),
                           pixel_bytes, pixel_bytes * header.width));
  }
  file.setFrameBuffer(frame_buffer);
  file.readPixels(header.min_y, header.min_y + static_cast<int>(header.height) - 1);
  return layers;
}

}  // namespace

Result<std::vector<ImageLayer>> decode_exr(std::span<const uint8_t> bytes, const std::string& name,
                                           ExrAttributes* attributes) {
  LUEUR_TRY(header, check_exr_header(bytes, name));
  try {
    MemoryInput input(bytes);
    Imf::InputFile file(input);
    const Imath::Box2i& window = file.header().dataWindow();
    if (window.min != Imath::V2i(header.min_x, header.min_y) ||
        window.max.x != int64_t{header.min_x} + header.width - 1 ||
        window.max.y != int64_t{header.min_y} + header.height - 1)
      return bad_exr(name, "its header is read in two ways");
    if (attributes)
      for (auto a = file.header().begin(); a != file.header().end(); ++a)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
          (*attributes)[a.name()] = text->value();
    return read_layers(file, header);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, name + ": memory ran out; use a smaller picture"};
  } catch (const std::exception& exception) {
    return bad_exr(name, exception.what());
  }
}

Result<std::vector<ImageLayer>> read_exr(const std::filesystem::path& path,
                                         ExrAttributes* attributes) {
  LUEUR_TRY(bytes, read_file(path, kMaxFileBytes));
  return decode_exr(bytes, path.string(), attributes);
}

}  // namespace lueur
