// SPDX-License-Identifier: MIT
// URIs: data URIs, and names of files, none of which may lead out of the folder.
#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/check.h"
#include "fuzz_input.h"
#include "scene/gltf_uri.h"

using namespace lueur;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view uri(reinterpret_cast<const char*>(data), size);
  if (is_data_uri(uri)) {
    const auto bytes = decode_data_uri(uri);
    if (bytes.ok()) LUEUR_CHECK_OP(bytes->size(), <=, uri.size());
    return 0;
  }
  static const std::filesystem::path folder = std::filesystem::canonical(".");
  const auto path = confined_path(folder, uri);
  if (!path.ok()) return 0;
  const auto ends = std::mismatch(folder.begin(), folder.end(), path->begin(), path->end());
  LUEUR_CHECK(ends.first == folder.end() && ends.second != path->end());
  return 0;
}
