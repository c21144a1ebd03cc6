// SPDX-License-Identifier: MIT
#include "scene/scene_file.h"

#include <array>
#include <fstream>
#include <string>

#include "scene/gltf_load.h"
#include "scene/obj_load.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

// The first bytes of a regular file; nothing of what cannot be read, which the reader then tells.
std::string beginning_of(const fs::path& path) {
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return {};
  std::array<char, 256> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<size_t>(file.gcount())};
}

// Whether a text begins as OBJ files do; glTF begins with a brace.
bool begins_as_obj(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  const std::string_view rest = text.substr(first);
  for (const std::string_view start : {"#", "mtllib ", "o ", "g ", "v ", "vn ", "vt ", "usemtl "})
    if (rest.starts_with(start)) return true;
  return false;
}

}  // namespace

bool has_scene_ending(const fs::path& path) {
  const std::string ending = ending_of(path);
  return ending == ".gltf" || ending == ".glb" || ending == ".obj";
}

Result<Scene> load_scene_file(const fs::path& path, const LoadLimits& limits) {
  const std::string beginning = beginning_of(path);
  const bool is_gltf = beginning.starts_with("glTF") || beginning.starts_with("{");
  const bool is_obj = !is_gltf && (ending_of(path) == ".obj" || begins_as_obj(beginning));
  return is_obj ? load_obj(path, limits) : load_gltf(path, limits);
}

}  // namespace lueur
