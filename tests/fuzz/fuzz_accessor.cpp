// SPDX-License-Identifier: MIT
// Accessors: a valid asset whose buffer views, accessors and bytes are chosen by the input. It has
// a mesh with all attributes and indices, so that every accessor is read.
#include <array>
#include <string>
#include <vector>

#include "fuzz_input.h"

using namespace lueur;

namespace {

constexpr std::array<uint32_t, 6> kComponents{5126, 5123, 5121, 5125, 5120, 5122};
constexpr std::array<uint32_t, 8> kOffsets{0, 4, 12, 36, 2, 1, 64, 128};
constexpr std::array<uint32_t, 8> kLengths{36, 48, 12, 24, 6, 96, 192, 0};
constexpr std::array<uint32_t, 6> kStrides{12, 16, 4, 8, 20, 252};
constexpr std::array<uint32_t, 6> kCounts{3, 4, 1, 6, 0, 12};
constexpr std::array<const char*, 8> kTypes{"VEC3", "VEC4", "VEC2", "SCALAR",
                                            "MAT4", "MAT3", "MAT2", "VEC5"};
constexpr uint32_t kAccessors = 6;

std::string member(const char* name, uint32_t value) {
  return std::string(",\"") + name + "\":" + std::to_string(value);
}

std::string view(FuzzInput& input) {
  std::string text = "{\"buffer\":0" + member("byteOffset", input.number(kOffsets)) +
                     member("byteLength", input.number(kLengths));
  if (input.byte() % 4 == 0) text += member("byteStride", input.number(kStrides));
  return text + "}";
}

std::string sparse(FuzzInput& input) {
  const std::string indices = "{\"bufferView\":" + std::to_string(input.byte() % kAccessors) +
                              member("componentType", input.number(kComponents)) + "}";
  const std::string values = "{\"bufferView\":" + std::to_string(input.byte() % kAccessors) +
                             member("byteOffset", input.number(kOffsets)) + "}";
  return ",\"sparse\":{\"indices\":" + indices + ",\"values\":" + values +
         member("count", input.number(kCounts)) + "}";
}

std::string accessor(FuzzInput& input) {
  const uint8_t flags = input.byte();
  std::string text = std::string("{\"type\":\"") + kTypes[input.byte() % kTypes.size()] + "\"" +
                     member("componentType", input.number(kComponents)) +
                     member("count", input.number(kCounts));
  if ((flags & 3) != 3) text += member("bufferView", input.byte() % (kAccessors + 1u));
  if ((flags & 12) == 12) text += member("byteOffset", input.number(kOffsets));
  if ((flags & 16) != 0) text += ",\"normalized\":true";
  if ((flags & 96) == 96) text += sparse(input);
  if ((flags & 128) != 0) text += ",\"min\":[0,0,0],\"max\":[1,1,1]";
  return text + "}";
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  uint32_t bits = 0;
  int bit_count = 0;
  for (const char c : bytes) {
    bits = bits << 8 | static_cast<uint8_t>(c);
    for (bit_count += 8; bit_count >= 6; bit_count -= 6)
      text += kDigits[bits >> (bit_count - 6) & 63u];
  }
  if (bit_count > 0) text += kDigits[bits << (6 - bit_count) & 63u];
  return text;
}

std::string list(FuzzInput& input, std::string (*element)(FuzzInput&)) {
  std::string text;
  for (uint32_t i = 0; i < kAccessors; ++i) text += (i > 0 ? "," : "") + element(input);
  return text;
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzInput input(data, size);
  const std::string mode = std::to_string(4 + input.byte() % 3);
  std::string json = R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],)"
                     R"("meshes":[{"primitives":[{"mode":)" +
                     mode + R"(,"attributes":{"POSITION":0)";
  const uint8_t used = input.byte();
  const std::array<const char*, 4> names{"NORMAL", "TANGENT", "TEXCOORD_0", "COLOR_0"};
  for (uint32_t i = 0; i < names.size(); ++i)
    if ((used >> i & 1) != 0) json += member(names[i], 1 + i);
  json += (used & 64) != 0 ? "},\"indices\":5}]}]" : "}}]}]";
  json += ",\"bufferViews\":[" + list(input, view) + "],\"accessors\":[" + list(input, accessor);
  const std::string bytes = input.rest();
  json += R"(],"buffers":[{"uri":"data:application/octet-stream;base64,)" + base64(bytes) +
          "\",\"byteLength\":" + std::to_string(bytes.size()) + "}]}";
  const auto scene =
      decode_gltf(std::vector<uint8_t>(json.begin(), json.end()), "input", fuzz_limits());
  if (scene.ok()) check_scene(*scene);
  return 0;
}
