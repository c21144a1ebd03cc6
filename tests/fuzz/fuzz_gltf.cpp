// SPDX-License-Identifier: MIT
// Whole files, text or GLB, with all their data inside.
#include <vector>

#include "fuzz_input.h"

using namespace lueur;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto scene = decode_gltf(std::vector<uint8_t>(data, data + size), "input", fuzz_limits());
  if (!scene.ok()) return 0;
  check_scene(*scene);
  check_completed(*scene);
  return 0;
}
