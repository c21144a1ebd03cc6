// SPDX-License-Identifier: MIT
// What the fuzz targets share: small limits, so that no input can be slow, numbers taken from the
// input, and what every scene promises.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "scene/gltf_load.h"

// Called by libFuzzer, or by replay.cpp, with one input.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace lueur {

// Inputs have a few KiB; nothing they ask for may take long.
inline LoadLimits fuzz_limits() {
  LoadLimits limits;
  limits.file_bytes = 1u << 20;
  limits.vertices = limits.indices = 1u << 12;
  limits.nodes = 256;
  limits.images = 8;
  limits.texture_side_px = 256;
  limits.texture_bytes = 1u << 20;
  limits.json_values = 1u << 14;
  return limits;
}

// Takes numbers off the front of an input; past its end they are 0.
class FuzzInput {
 public:
  FuzzInput(const uint8_t* data, size_t size) : rest_(data, size) {}

  uint8_t byte() {
    if (rest_.empty()) return 0;
    const uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  uint32_t word() {
    uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | byte();
    return value;
  }
  // Mostly one of `usual`, sometimes any number.
  uint32_t number(std::span<const uint32_t> usual) {
    const uint8_t choice = byte();
    return choice < 0xf0 ? usual[choice % usual.size()] : word();
  }
  std::string rest() const { return {rest_.begin(), rest_.end()}; }

 private:
  std::span<const uint8_t> rest_;
};

// Stops the program where a loaded scene breaks a promise of scene.h.
void check_scene(const Scene& scene);
// The same for what complete() adds to it, which takes longer than to load a small file.
void check_completed(const Scene& scene);

}  // namespace lueur
