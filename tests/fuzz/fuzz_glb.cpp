// SPDX-License-Identifier: MIT
// The GLB container: chunks of chosen kinds and lengths around a small valid asset. An input whose
// first byte is not 0 is taken as the file itself.
#include <array>
#include <vector>

#include "fuzz_input.h"
#include "scene/gltf_file.h"

using namespace lueur;

namespace {

constexpr std::array<uint32_t, 3> kChunkTypes{0x4E4F534A, 0x004E4942, 0x4b4e55};

void append_u32(std::vector<uint8_t>& bytes, uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<uint8_t>(value >> (8 * i) & 0xff));
}

std::vector<uint8_t> container(FuzzInput& input) {
  const std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4}],)"
                           R"("bufferViews":[{"buffer":0,"byteLength":4}]})";
  std::vector<uint8_t> chunks;
  const uint32_t count = input.byte() % 5u;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t type = input.number(kChunkTypes);
    const bool is_json = type == kChunkTypes[0];
    const std::array<uint32_t, 3> sizes{is_json ? static_cast<uint32_t>(json.size()) : 4u, 0u, 5u};
    const uint32_t size = input.number(sizes);
    append_u32(chunks, size);
    append_u32(chunks, type);
    for (uint32_t k = 0; k < size && k < 256; ++k)
      chunks.push_back(is_json && k < json.size() ? static_cast<uint8_t>(json[k]) : ' ');
  }
  std::vector<uint8_t> file;
  const uint32_t whole = static_cast<uint32_t>(chunks.size()) + 12;
  append_u32(file, 0x46546C67);
  append_u32(file, input.number(std::array<uint32_t, 1>{2}));
  append_u32(file, input.number(std::array<uint32_t, 3>{whole, whole - 1, whole + 1}));
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzInput input(data, size);
  std::vector<uint8_t> bytes(data, data + size);
  if (input.byte() == 0) bytes = container(input);
  const auto file = GltfFile::from_bytes(std::move(bytes), "input", fuzz_limits());
  if (!file.ok()) return 0;
  for (size_t i = 0; i < file->size_of("bufferViews"); ++i)
    (void)file->view(static_cast<int32_t>(i));
  return 0;
}
