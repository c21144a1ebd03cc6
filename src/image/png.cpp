// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <new>
#include <vector>

#include "base/check.h"
#include "base/file.h"
#include "base/try.h"

namespace lueur {
namespace {

constexpr uint64_t kMaxFileBytes = uint64_t{1} << 29;
constexpr uint64_t kDeflateMaxRatio = 1032;  // no deflate stream grows by more

// What libpng's callbacks share with the code around them.
struct PngInput {
  std::span<const uint8_t> bytes;
  size_t position = 0;
  char reason[128] = {};
};

void take_bytes(png_structp png, png_bytep destination, size_t count) {
  auto& input = *static_cast<PngInput*>(png_get_io_ptr(png));
  if (count > input.bytes.size() - input.position) png_error(png, "it is cut short");
  std::memcpy(destination, input.bytes.data() + input.position, count);
  input.position += count;
}

[[noreturn]] void note_error(png_structp png, png_const_charp message) {
  auto& input = *static_cast<PngInput*>(png_get_error_ptr(png));
  std::strncpy(input.reason, message, sizeof(input.reason) - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

// libpng returns from its errors by longjmp, which skips destructors: the two functions below hold
// nothing that has one. They return false after an error, with the reason in the PngInput.

// Reads up to the pixels and asks for 8-bit RGBA.
bool read_header(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, kMaxPngSide, kMaxPngSide);
  png_set_chunk_malloc_max(png, 1 << 23);
  png_read_info(png, info);
  return true;
}

bool read_pixels(png_structp png, png_infop info, png_bytep* rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != size_t{4} * png_get_image_width(png, info))
    png_error(png, "its pixels cannot be turned into RGBA");
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

// Owns libpng's two structures.
struct PngReader {
  explicit PngReader(PngInput* input)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, input, note_error, ignore_warning)),
        info(png != nullptr ? png_create_info_struct(png) : nullptr) {
    if (info != nullptr) png_set_read_fn(png, input, take_bytes);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  png_structp png;
  png_infop info;
};

Error bad_png(const std::string& name, const std::string& reason) {
  return {ErrorKind::input, name + ": not a usable PNG: " + reason};
}

Error out_of_memory(const std::string& name) {
  return {ErrorKind::memory, name + ": memory ran out; use a smaller picture"};
}

// Takes memory for the pixels, unless the limits or the length of the data forbid it.
Result<Image8> allocate(const PngReader& reader, size_t data_bytes, const std::string& name) {
  const uint32_t width = png_get_image_width(reader.png, reader.info);
  const uint32_t height = png_get_image_height(reader.png, reader.info);
  if (uint64_t{width} * height > kMaxPngPixels)
    return bad_png(name, std::to_string(width) + "x" + std::to_string(height) +
                             " pixels, more than the limit of " + std::to_string(kMaxPngPixels));
  const uint64_t raw_bytes = uint64_t{png_get_rowbytes(reader.png, reader.info)} * height;
  if (raw_bytes / kDeflateMaxRatio > data_bytes) return bad_png(name, "it is cut short");
  Image8 image;
  image.width = width;
  image.height = height;
  image.channels = 4;
  image.samples.resize(size_t{width} * height * 4);
  return image;
}

Result<Image8> decode(std::span<const uint8_t> bytes, const std::string& name) {
  if (png_sig_cmp(bytes.data(), 0, std::min<size_t>(bytes.size(), 8)) != 0 || bytes.size() < 8)
    return bad_png(name, "it does not start like one");
  PngInput input;
  input.bytes = bytes;
  PngReader reader(&input);
  if (reader.info == nullptr) return out_of_memory(name);
  if (!read_header(reader.png, reader.info)) return bad_png(name, input.reason);
  LUEUR_TRY(image, allocate(reader, bytes.size(), name));
  std::vector<png_bytep> rows(image.height);
  for (uint32_t y = 0; y < image.height; ++y)
    rows[y] = image.samples.data() + size_t{y} * image.width * 4;
  if (!read_pixels(reader.png, reader.info, rows.data())) return bad_png(name, input.reason);
  return std::move(image);
}

}  // namespace

Result<Image8> decode_png(std::span<const uint8_t> bytes, const std::string& name) {
  try {
    return decode(bytes, name);
  } catch (const std::bad_alloc&) {
    return out_of_memory(name);
  }
}

Result<Image8> read_png(const std::filesystem::path& path) {
  LUEUR_TRY(bytes, read_file(path, kMaxFileBytes));
  return decode_png(bytes, path.string());
}

Result<std::vector<uint8_t>> encode_png(const Image8& image, const std::string& name) {
  LUEUR_CHECK(image.channels == 3 || image.channels == 4);
  LUEUR_CHECK_OP(image.samples.size(), ==, size_t{image.width} * image.height * image.channels);
  if (image.width == 0 || image.height == 0 || uint64_t{image.width} * image.height > kMaxPngPixels)
    return Error{ErrorKind::output, name + ": a PNG holds 1 to " + std::to_string(kMaxPngPixels) +
                                        " pixels, not " + std::to_string(image.width) + "x" +
                                        std::to_string(image.height)};
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width;
  png.height = image.height;
  png.format = image.channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;

  try {
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<uint8_t> bytes(size);
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.samples.data(), 0, nullptr) ==
        0)
      return Error{ErrorKind::output, name + ": cannot be encoded: " + png.message};
    bytes.resize(size);
    return bytes;
  } catch (const std::bad_alloc&) {
    return out_of_memory(name);
  }
}

Result<void> write_png(const std::filesystem::path& path, const Image8& image) {
  // Encode in memory, so that the file appears complete or not at all.
  LUEUR_TRY(bytes, encode_png(image, path.string()));
  return write_file(path, std::span<const uint8_t>(bytes));
}

}  // namespace lueur
