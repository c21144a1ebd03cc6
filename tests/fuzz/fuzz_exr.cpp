// SPDX-License-Identifier: MIT
// EXR pictures. The header alone is read of those that would be slow to decode.
#include "fuzz_input.h"
#include "image/exr.h"
#include "image/exr_header.h"

using namespace lueur;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::span<const uint8_t> bytes(data, size);
  const auto header = check_exr_header(bytes, "input");
  constexpr uint64_t kMaxSamples = 1u << 14;
  if (!header.ok() || uint64_t{header->width} * header->height * header->channels > kMaxSamples)
    return 0;
  ExrAttributes attributes;
  (void)decode_exr(bytes, "input", &attributes);
  return 0;
}
