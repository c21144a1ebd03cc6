// SPDX-License-Identifier: MIT
#include "scene/glb_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace lueur {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

GlbWriter::GlbWriter() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "lueur"}};
}

int GlbWriter::add_to(const char* array, Json element) {
  json_[array].push_back(std::move(element));
  return int(json_[array].size()) - 1;
}

int GlbWriter::add_view(std::span<const uint8_t> bytes, int target, int stride) {
  buffer_.resize((buffer_.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (stride != 0) view["byteStride"] = stride;
  if (target != 0) view["target"] = target;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  return add_to("bufferViews", std::move(view));
}

int GlbWriter::add_accessor(int view, size_t offset, int component, const char* type,
                            size_t count) {
  return add_to("accessors", {{"bufferView", view},
                              {"byteOffset", offset},
                              {"componentType", component},
                              {"count", count},
                              {"type", type}});
}

void GlbWriter::use_extension(const char* name) {
  Json& used = json_["extensionsUsed"];
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

// Header, JSON chunk padded with spaces, binary chunk padded with zeros.
Result<std::vector<uint8_t>> GlbWriter::assemble(const std::string& name) {
  buffer_.resize((buffer_.size() + 3) / 4 * 4);
  if (!buffer_.empty()) add_to("buffers", {{"byteLength", buffer_.size()}});
  std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const size_t total = 12 + 8 + text.size() + (buffer_.empty() ? 0 : 8 + buffer_.size());
  if (total > std::numeric_limits<uint32_t>::max())
    return Error{ErrorKind::output, "scene '" + name + "' needs " + std::to_string(total) +
                                        " bytes as GLB, which allows 4 GiB; export less of it"};
  std::vector<uint8_t> file;
  file.reserve(total);
  const auto put = [&](size_t value) {
    const auto bytes = std::bit_cast<std::array<uint8_t, 4>>(uint32_t(value));
    file.insert(file.end(), bytes.begin(), bytes.end());
  };
  put(0x46546c67);  // "glTF"
  put(2);
  put(total);
  put(text.size());
  put(0x4e4f534a);  // "JSON"
  file.insert(file.end(), text.begin(), text.end());
  if (buffer_.empty()) return file;
  put(buffer_.size());
  put(0x004e4942);  // "BIN"
  file.insert(file.end(), buffer_.begin(), buffer_.end());
  return file;
}

}  // namespace lueur
