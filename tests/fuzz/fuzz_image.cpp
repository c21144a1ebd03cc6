// SPDX-License-Identifier: MIT
// PNG and JPEG, as textures and as the pictures of `lueur diff`. The checksums of PNG chunks are
// put right first: otherwise hardly any change of the input would get past them.
#include <zlib.h>

#include <vector>

#include "fuzz_input.h"
#include "image/png.h"
#include "scene/image_decode.h"

using namespace lueur;

namespace {

uint32_t read_u32(std::span<const uint8_t> bytes, size_t at) {
  return uint32_t{bytes[at]} << 24 | uint32_t{bytes[at + 1]} << 16 | uint32_t{bytes[at + 2]} << 8 |
         bytes[at + 3];
}

void mend_checksums(std::span<uint8_t> png) {
  constexpr size_t kSignature = 8, kFrame = 12;  // a chunk's length, type and checksum
  for (size_t at = kSignature; at + kFrame <= png.size();) {
    const uint32_t length = read_u32(png, at);
    if (length > png.size() - at - kFrame) return;
    const size_t end = at + 8 + length;
    const uint32_t sum = static_cast<uint32_t>(crc32(0, png.data() + at + 4, length + 4));
    for (size_t i = 0; i < 4; ++i) png[end + i] = static_cast<uint8_t>(sum >> (24 - 8 * i) & 0xff);
    at = end + 4;
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::vector<uint8_t> bytes(data, data + size);
  const auto header = read_image_header(bytes);
  const uint32_t limit = fuzz_limits().texture_side_px;
  if (!header.ok() || header->width == 0 || header->height == 0 || header->width > limit ||
      header->height > limit)
    return 0;
  if (header->format == ImageFormat::png) mend_checksums(bytes);
  std::vector<uint8_t> rgba(size_t{header->width} * header->height * 4);
  (void)decode_image(bytes, *header, rgba);
  if (header->format == ImageFormat::png) (void)decode_png(bytes, "input");
  return 0;
}
