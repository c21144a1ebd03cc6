// SPDX-License-Identifier: MIT
// A binary glTF file in the making: its JSON and its one buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "lueur/result.h"

namespace lueur {

// glTF's numbers for component types and for what a view is bound as.
inline constexpr int kGltfFloat = 5126, kGltfUint32 = 5125, kGltfUint16 = 5123;
inline constexpr int kGltfArrayBuffer = 34962, kGltfElementArrayBuffer = 34963;

class GlbWriter {
 public:
  using Json = nlohmann::ordered_json;

  GlbWriter();

  // The top-level object.
  Json& json() { return json_; }

  // Appends to a top-level array and returns the element's index. The array is made with its first
  // element: glTF forbids empty ones.
  int add_to(const char* array, Json element);

  // Appends bytes to the buffer, aligned for any component type; returns the view's index.
  int add_view(std::span<const uint8_t> bytes, int target = 0, int stride = 0);
  int add_accessor(int view, size_t offset, int component, const char* type, size_t count);

  // An accessor of a view of its own.
  template <class T>
  int add_array(const std::vector<T>& values, int component, const char* type, int target = 0) {
    return add_accessor(add_view(bytes_of(values), target), 0, component, type, values.size());
  }

  template <class T>
  static std::span<const uint8_t> bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const uint8_t*>(values.data()), values.size() * sizeof(T)};
  }

  // Lists an extension, once.
  void use_extension(const char* name);

  // The whole file; `name` is for messages. Fails (ErrorKind::output) beyond glTF's 4 GiB.
  Result<std::vector<uint8_t>> assemble(const std::string& name);

 private:
  Json json_;
  std::vector<uint8_t> buffer_;
};

inline GlbWriter::Json vector_json(const glm::vec3& v) {
  return GlbWriter::Json::array({v.x, v.y, v.z});
}
inline GlbWriter::Json vector_json(const glm::vec4& v) {
  return GlbWriter::Json::array({v.x, v.y, v.z, v.w});
}

}  // namespace lueur
