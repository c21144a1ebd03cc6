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

  // What `uri` at `at` holds; counts towards LoadLimits::file_bytes.
  Result<std::vector<uint8_t>> read_uri(const std::string& uri, const JsonCursor& at);

 private:
  GltfFile() = default;
  Result<void> split_glb();
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
  std::filesystem::path folder_;
  LoadLimits limits_;
  std::vector<uint8_t> bytes_;
  std::span<const uint8_t> json_text_;
  std::optional<std::span<const uint8_t>> binary_chunk_;
  Json json_;
  std::vector<Buffer> buffers_;
  std::vector<std::optional<std::vector<uint8_t>>> decoded_views_;  // of compressed views
  uint64_t bytes_read_ = 0;
};

}  // namespace lueur
