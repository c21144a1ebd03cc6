// SPDX-License-Identifier: MIT
// A glTF asset opened: its JSON, and its buffers as checked byte ranges.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_json.h"
#include "scene/load_limits.h"
#include "scene/warnings.h"

namespace lueur {

// Whether files may require the extension: what it adds is read.
bool is_supported(std::string_view extension);
// What a user can do about an extension that is not supported.
std::string remedy_for(std::string_view extension);

class GltfFile {
 public:
  // Reads the file and all its buffers and refuses required extensions that are not supported.
  static Result<GltfFile> open(const std::filesystem::path& path, const LoadLimits& limits);
  // The same for a file that is in memory, which `name` stands for in messages. It has no folder:
  // all its buffers and images have to be in it.
  static Result<GltfFile> from_bytes(std::vector<uint8_t> bytes, const std::string& name,
                                     const LoadLimits& limits);

  const Json& json() const { return json_; }
  JsonCursor root() const { return JsonCursor(json_, name_); }
  const LoadLimits& limits() const { return limits_; }
  const std::string& name() const { return name_; }

  // Elements of the root's array `key`; 0 if it is absent.
  size_t size_of(const char* key) const;

  struct View {
    std::span<const uint8_t> bytes;
    uint32_t stride = 0;  // 0: tightly packed
  };
  // Buffer view `view`, which must be below size_of("bufferViews"). Valid as long as the file.
  Result<View> view(int32_t view) const;

  bool is_binary() const { return json_text_.data() != bytes_.data(); }
  // Whether the file gives the bytes of a buffer, which must be below size_of("buffers").
  bool has_data(size_t buffer) const { return buffers_[buffer].bytes.has_value(); }
  // Whether the buffer of a view gives its bytes; true for views that are malformed.
  bool view_has_data(int32_t view) const;
  // All buffers together.
  uint64_t buffer_bytes() const;

  // Where the container and its text break the rules of glTF without being in the way of reading
  // it.
  const std::vector<std::string>& container_faults() const { return container_faults_; }

  // Of the file that `uri` names, its first bytes, at most `max_bytes`.
  Result<std::vector<uint8_t>> head_of_uri(const std::string& uri, size_t max_bytes) const;

  // What `uri` at `at` holds; counts towards LoadLimits::file_bytes.
  Result<std::vector<uint8_t>> read_uri(const std::string& uri, const JsonCursor& at);

 private:
  GltfFile() = default;
  static Result<GltfFile> parse(GltfFile file);
  Result<void> split_glb();
  void add_container_fault(std::string what);
  Result<void> check_header() const;
  Result<void> read_buffers();
  Result<void> decode_views();
  Result<std::span<const uint8_t>> bytes_of(const JsonCursor& at, int32_t buffer, uint64_t offset,
                                            uint64_t length) const;

  struct Buffer {
    std::vector<uint8_t> storage;  // empty for the binary chunk, which lies in bytes_
    std::optional<std::span<const uint8_t>> bytes;  // none: the file gives no data for it
  };

  std::string name_;
  std::optional<std::filesystem::path> folder_;  // none: the file is in memory
  LoadLimits limits_;
  std::vector<uint8_t> bytes_;
  std::span<const uint8_t> json_text_;
  std::optional<std::span<const uint8_t>> binary_chunk_;
  Json json_;
  std::vector<Buffer> buffers_;
  std::vector<std::optional<std::vector<uint8_t>>> decoded_views_;  // of compressed views
  uint64_t bytes_read_ = 0;
  std::vector<std::string> container_faults_;
};

}  // namespace lueur
