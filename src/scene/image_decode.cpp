// SPDX-License-Identifier: MIT
#include "scene/image_decode.h"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "base/try.h"

namespace lueur {
namespace {

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kJpegSignature("\xff\xd8\xff", 3);
constexpr size_t kMaxReason = 128;

Error damaged(const char* format, std::string_view reason) {
  return {ErrorKind::input,
          std::string("damaged ") + format + " image (" + std::string(reason) + ")"};
}

bool starts_with(std::span<const uint8_t> bytes, std::string_view signature) {
  return bytes.size() >= signature.size() &&
         std::memcmp(bytes.data(), signature.data(), signature.size()) == 0;
}

struct Decompressor {
  tjhandle handle = tjInitDecompress();
  Decompressor() = default;
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;
  ~Decompressor() {
    if (handle) tjDestroy(handle);
  }
};

Result<ImageHeader> read_png_header(std::span<const uint8_t> bytes) {
  constexpr size_t kSizeOffset = 16;
  if (bytes.size() < kSizeOffset + 8 || std::memcmp(bytes.data() + 12, "IHDR", 4) != 0)
    return damaged("PNG", "no header");
  ImageHeader header;
  header.format = ImageFormat::png;
  header.width = png_get_uint_32(bytes.data() + kSizeOffset);
  header.height = png_get_uint_32(bytes.data() + kSizeOffset + 4);
  return header;
}

Result<ImageHeader> read_jpeg_header(std::span<const uint8_t> bytes) {
  const Decompressor jpeg;
  int width = 0, height = 0, subsampling = 0, color_space = 0;
  if (!jpeg.handle) return Error{ErrorKind::memory, "no memory for the JPEG decoder"};
  if (tjDecompressHeader3(jpeg.handle, bytes.data(), bytes.size(), &width, &height, &subsampling,
                          &color_space) != 0)
    return damaged("JPEG", tjGetErrorStr2(jpeg.handle));
  ImageHeader header;
  header.format = ImageFormat::jpeg;
  header.width = static_cast<uint32_t>(std::max(width, 0));
  header.height = static_cast<uint32_t>(std::max(height, 0));
  return header;
}

struct PngSource {
  const uint8_t* data;
  size_t size;
  size_t at;
};

void on_png_read(png_structp png, png_bytep out, size_t size) {
  PngSource& source = *static_cast<PngSource*>(png_get_io_ptr(png));
  if (size > source.size - source.at) png_error(png, "truncated");
  std::memcpy(out, source.data + source.at, size);
  source.at += size;
}

[[noreturn]] void on_png_error(png_structp png, png_const_charp message) {
  std::snprintf(static_cast<char*>(png_get_error_ptr(png)), kMaxReason, "%s", message);
  png_longjmp(png, 1);
}

void on_png_warning(png_structp, png_const_charp) {}

// libpng reports errors by longjmp: this function holds nothing with a destructor.
bool decode_png_rows(PngSource* source, const ImageHeader& header, png_bytep* rows, char* reason) {
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, reason, on_png_error, on_png_warning);
  if (!png) return false;
  png_infop info = png_create_info_struct(png);
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_read_struct(&png, info ? &info : nullptr, nullptr);
    return false;
  }
  // Skip text, profiles and unknown chunks, which could inflate to any size.
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_chunk_malloc_max(png, 1u << 20);
  png_set_user_limits(png, header.width, header.height);
  png_set_read_fn(png, source, on_png_read);
  png_read_info(png, info);

  // Turn every colour type into 8-bit RGBA.
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_image_width(png, info) != header.width ||
      png_get_image_height(png, info) != header.height ||
      png_get_rowbytes(png, info) != size_t{header.width} * 4)
    png_error(png, "unexpected layout");
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  png_destroy_read_struct(&png, &info, nullptr);
  return true;
}

Result<void> decode_png(std::span<const uint8_t> bytes, const ImageHeader& header,
                        std::span<uint8_t> rgba) {
  std::vector<png_bytep> rows(header.height);
  for (size_t y = 0; y < rows.size(); ++y) rows[y] = rgba.data() + y * header.width * 4;
  PngSource source{bytes.data(), bytes.size(), 0};
  std::array<char, kMaxReason> reason{};
  if (!decode_png_rows(&source, header, rows.data(), reason.data()))
    return damaged("PNG", reason.data());
  return {};
}

Result<void> decode_jpeg(std::span<const uint8_t> bytes, const ImageHeader& header,
                         std::span<uint8_t> rgba) {
  const Decompressor jpeg;
  if (!jpeg.handle) return Error{ErrorKind::memory, "no memory for the JPEG decoder"};
  // Limit the scans: a progressive file may hold thousands for each of which the picture is redone.
  if (tjDecompress2(jpeg.handle, bytes.data(), bytes.size(), rgba.data(),
                    static_cast<int>(header.width), 0, static_cast<int>(header.height), TJPF_RGBA,
                    TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT) != 0)
    return damaged("JPEG", tjGetErrorStr2(jpeg.handle));
  return {};
}

}  // namespace

Result<ImageHeader> read_image_header(std::span<const uint8_t> bytes) {
  if (starts_with(bytes, kPngSignature)) return read_png_header(bytes);
  if (starts_with(bytes, kJpegSignature)) return read_jpeg_header(bytes);
  const char* format = "neither PNG nor JPEG";
  if (starts_with(bytes, "RIFF")) format = "WebP, not PNG or JPEG";
  if (starts_with(bytes, "\xabKTX")) format = "KTX, not PNG or JPEG";
  if (starts_with(bytes, "DDS ")) format = "DDS, not PNG or JPEG";
  return Error{ErrorKind::input, std::string("the image is ") + format +
                                     "; convert it, e.g. 'gltf-transform png in.glb out.glb'"};
}

Result<void> decode_image(std::span<const uint8_t> bytes, const ImageHeader& header,
                          std::span<uint8_t> rgba) {
  LUEUR_CHECK_OP(rgba.size(), ==, size_t{header.width} * header.height * 4);
  return header.format == ImageFormat::png ? decode_png(bytes, header, rgba)
                                           : decode_jpeg(bytes, header, rgba);
}

}  // namespace lueur
