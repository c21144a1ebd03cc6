// SPDX-License-Identifier: MIT
#include "image/exr_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/try.h"
#include "image/exr.h"

namespace lueur {
namespace {

constexpr uint32_t kMagic = 20000630;
constexpr uint32_t kTiledFlag = 0x200;
constexpr uint32_t kDeepFlag = 0x800;
constexpr uint32_t kMultiPartFlag = 0x1000;
constexpr size_t kMaxNameBytes = 255;
constexpr std::string_view kScanLineType = "scanlineimage";

// Lines in one compressed block, by the number in the compression attribute; 0 is refused.
constexpr std::array<uint32_t, 10> kBlockLines = {
    1,   // none
    1,   // RLE
    1,   // ZIPS
    16,  // ZIP
    32,  // PIZ
    16,  // PXR24
    0,   // B44
    0,   // B44A
    0,   // DWAA
    0,   // DWAB
};

struct FixedType {
  std::string_view name;
  size_t bytes;
};
// The types of attributes whose values have one size. The library reads that many bytes whatever
// the size in the file is, so that with another one it would go on at another place than we do.
constexpr std::array kFixedTypes = {FixedType{"box2f", 16},
                                    FixedType{"box2i", 16},
                                    FixedType{"chromaticities", 32},
                                    FixedType{"compression", 1},
                                    FixedType{"deepImageState", 1},
                                    FixedType{"double", 8},
                                    FixedType{"envmap", 1},
                                    FixedType{"float", 4},
                                    FixedType{"int", 4},
                                    FixedType{"keycode", 28},
                                    FixedType{"lineOrder", 1},
                                    FixedType{"m33d", 72},
                                    FixedType{"m33f", 36},
                                    FixedType{"m44d", 128},
                                    FixedType{"m44f", 64},
                                    FixedType{"rational", 8},
                                    FixedType{"tiledesc", 9},
                                    FixedType{"timecode", 8},
                                    FixedType{"v2d", 16},
                                    FixedType{"v2f", 8},
                                    FixedType{"v2i", 8},
                                    FixedType{"v3d", 24},
                                    FixedType{"v3f", 12},
                                    FixedType{"v3i", 12}};

// Reads forward through bytes; every read says whether there was enough left.
class Cursor {
 public:
  explicit Cursor(std::span<const uint8_t> bytes) : rest_(bytes) {}

  size_t left() const { return rest_.size(); }

  // EXR is little-endian throughout.
  std::optional<uint32_t> u32() {
    const auto bytes = take(4);
    if (!bytes) return std::nullopt;
    uint32_t value = 0;
    for (size_t i = 4; i-- > 0;) value = value << 8 | (*bytes)[i];
    return value;
  }

  // A name that ends in a zero byte; the zero is passed over.
  std::optional<std::string_view> text() {
    const size_t limit = std::min(rest_.size(), kMaxNameBytes + 1);
    const auto end = std::find(rest_.begin(), rest_.begin() + limit, uint8_t{0});
    if (end == rest_.begin() + limit) return std::nullopt;
    const size_t length = static_cast<size_t>(end - rest_.begin());
    const std::string_view value(reinterpret_cast<const char*>(rest_.data()), length);
    rest_ = rest_.subspan(length + 1);
    return value;
  }

  std::optional<std::span<const uint8_t>> take(size_t count) {
    if (count > rest_.size()) return std::nullopt;
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

 private:
  std::span<const uint8_t> rest_;
};

Result<void> check_version(Cursor& cursor, const std::string& name) {
  const auto magic = cursor.u32();
  const auto version = cursor.u32();
  if (!magic || *magic != kMagic || !version) return bad_exr(name, "it does not start like one");
  if ((*version & 0xff) != 2) return bad_exr(name, "its version is not 2");
  if ((*version & kDeepFlag) != 0) return bad_exr(name, "deep pictures are not supported");
  if ((*version & kMultiPartFlag) != 0)
    return bad_exr(name, "multi-part files are not supported; write a single part");
  if ((*version & kTiledFlag) != 0)
    return bad_exr(name, "tiled files are not supported; write scan lines");
  return {};
}

// `value`: min x, min y, max x, max y, inclusive.
Result<void> read_data_window(std::span<const uint8_t> value, const std::string& name,
                              ExrHeader& header) {
  Cursor cursor(value);
  std::array<int32_t, 4> box = {};
  for (int32_t& side : box) {
    const auto number = cursor.u32();
    if (!number) return bad_exr(name, "its dataWindow is cut short");
    side = static_cast<int32_t>(*number);
  }
  const int64_t width = int64_t{box[2]} - box[0] + 1;
  const int64_t height = int64_t{box[3]} - box[1] + 1;
  if (width < 1 || height < 1 || width > kMaxExrSide || height > kMaxExrSide)
    return bad_exr(name, "its dataWindow is " + std::to_string(width) + "x" +
                             std::to_string(height) + ", outside 1 to " +
                             std::to_string(kMaxExrSide) + " pixels a side");
  header.min_x = box[0];
  header.min_y = box[1];
  header.width = static_cast<uint32_t>(width);
  header.height = static_cast<uint32_t>(height);
  return {};
}

// `value`: for each channel its name, type, 4 bytes, x and y sampling; then an empty name.
Result<void> read_channels(std::span<const uint8_t> value, const std::string& name,
                           ExrHeader& header) {
  Cursor cursor(value);
  for (;;) {
    const auto channel = cursor.text();
    if (channel && channel->empty()) {
      // The library stops at the empty name, too, and would take the rest for attributes.
      if (cursor.left() > 0) return bad_exr(name, "its list of channels is damaged");
      break;
    }
    const auto type = cursor.u32();
    const auto linear = cursor.u32();
    const auto sampling_x = cursor.u32();
    const auto sampling_y = cursor.u32();
    if (!channel || !type || !linear || !sampling_x || !sampling_y)
      return bad_exr(name, "its list of channels is damaged");
    if (*type > 2) return bad_exr(name, "a channel has an unknown type of samples");
    if (*sampling_x != 1 || *sampling_y != 1)
      return bad_exr(name, "a channel is subsampled; write all channels in full size");
    if (++header.channels > kMaxExrChannels)
      return bad_exr(name, "more than " + std::to_string(kMaxExrChannels) + " channels");
  }
  return {};
}

// Whether the library reads exactly `value` for an attribute of that type.
bool has_size_of_type(std::string_view type, std::span<const uint8_t> value) {
  const auto fixed = std::ranges::find(kFixedTypes, type, &FixedType::name);
  if (fixed != kFixedTypes.end()) return value.size() == fixed->bytes;
  Cursor cursor(value);
  if (type == "floatvector") return value.size() % 4 == 0;
  if (type == "preview") {
    const auto width = cursor.u32(), height = cursor.u32();
    return width && height && uint64_t{*width} * *height == uint64_t{cursor.left()} / 4 &&
           cursor.left() % 4 == 0;
  }
  while (type == "stringvector" && cursor.left() > 0) {
    const auto length = cursor.u32();
    if (!length || !cursor.take(*length)) return false;
  }
  return true;
}

}  // namespace

Error bad_exr(const std::string& name, std::string reason) {
  std::ranges::replace_if(
      reason, [](char c) { return c < ' ' || c > '~'; }, '?');
  return {ErrorKind::input, name + ": not a usable EXR: " + reason};
}

Result<ExrHeader> check_exr_header(std::span<const uint8_t> bytes, const std::string& name) {
  Cursor cursor(bytes);
  LUEUR_TRY_VOID(check_version(cursor, name));
  ExrHeader header;
  std::optional<uint32_t> block_lines;

  // Walk over the attributes: name, type, size, value. An empty name ends the header. One that
  // comes twice is refused, since the library might believe the other one.
  for (;;) {
    const auto attribute = cursor.text();
    if (attribute && attribute->empty()) break;
    const auto type = cursor.text();
    const auto size = cursor.u32();
    if (!attribute || !type || !size) return bad_exr(name, "its header is damaged");
    const auto value = cursor.take(*size);
    if (!value) return bad_exr(name, "its attribute " + std::string(*attribute) + " is cut short");
    if (!has_size_of_type(*type, *value))
      return bad_exr(name, "its attribute " + std::string(*attribute) + " has a wrong size");
    if (*type == "idmanifest" || (*type == "chlist" && *attribute != "channels"))
      return bad_exr(name, "attributes of type " + std::string(*type) + " are not supported");
    if (*attribute == "dataWindow") {
      if (header.width != 0) return bad_exr(name, "two attributes dataWindow");
      LUEUR_TRY_VOID(read_data_window(*value, name, header));
    } else if (*attribute == "channels") {
      if (header.channels != 0) return bad_exr(name, "two attributes channels");
      LUEUR_TRY_VOID(read_channels(*value, name, header));
    } else if (*attribute == "compression") {
      if (block_lines || value->size() != 1 || value->front() >= kBlockLines.size())
        return bad_exr(name, "its compression is unknown");
      block_lines = kBlockLines[value->front()];
    } else if (*attribute == "type" && !std::ranges::equal(*value, kScanLineType)) {
      return bad_exr(name, "its type is not scanlineimage");
    }
  }
  if (header.width == 0 || header.channels == 0 || !block_lines)
    return bad_exr(name, "dataWindow, channels or compression is missing");
  if (*block_lines == 0)
    return bad_exr(name, "B44 and DWA compression are not supported; write it with ZIP or PIZ");
  if (uint64_t{header.width} * header.height * header.channels > kMaxExrSamples)
    return bad_exr(name, "more than " + std::to_string(kMaxExrSamples) + " samples");

  // Each block needs an offset of 8 bytes and a head of 8: a file without room for them is cut.
  const uint64_t blocks = (header.height + *block_lines - 1) / *block_lines;
  if (blocks * 16 > cursor.left()) return bad_exr(name, "it is cut short");
  return header;
}

}  // namespace lueur
