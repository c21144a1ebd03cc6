// SPDX-License-Identifier: MIT
// Radiance pictures. Those that would be large are left out: a few bytes of run lengths fill them.
#include <cstdio>
#include <string>

#include "base/check.h"
#include "fuzz_input.h"
#include "image/hdr.h"

using namespace lueur;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const size_t end = text.find("\n\n");
  unsigned first = 0, second = 0;
  constexpr uint64_t kMaxPixels = 1u << 14;
  if (end != std::string::npos &&
      std::sscanf(text.c_str() + end + 2, "%*2s %u %*2s %u", &first, &second) == 2 &&
      uint64_t{first} * second > kMaxPixels)
    return 0;
  const auto image = decode_hdr({data, size}, "input");
  if (image.ok())
    LUEUR_CHECK_OP(image->samples.size(), ==, size_t{image->width} * image->height * 3);
  return 0;
}
