// SPDX-License-Identifier: MIT
#include "image/hdr.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <new>
#include <optional>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "base/try.h"

namespace lueur {
namespace {

constexpr uint64_t kMaxFileBytes = uint64_t{1} << 30;
constexpr std::string_view kSignature = "#?";

using Rgbe = std::array<uint8_t, 4>;

// How the file's scan lines lie in the picture.
struct Layout {
  uint32_t lines = 0;        // scan lines
  uint32_t line_pixels = 0;  // of each
  bool lines_are_rows = true;
  bool x_grows = true;   // to the right, in the order of the file
  bool y_grows = false;  // upwards

  uint32_t width() const { return lines_are_rows ? line_pixels : lines; }
  uint32_t height() const { return lines_are_rows ? lines : line_pixels; }
};

class HdrReader {
 public:
  HdrReader(std::span<const uint8_t> bytes, const std::string& name) : rest_(bytes), name_(name) {}
  Result<ImageF> read();

 private:
  Error bad(std::string reason) const;
  std::optional<std::string_view> line();
  std::optional<uint8_t> byte();
  Result<void> read_header();
  Result<void> read_factors(std::string_view values, size_t count, const char* what);
  Result<Layout> read_layout();
  Result<void> read_scan_line(std::span<Rgbe> pixels);
  Result<void> read_new_runs(std::span<Rgbe> pixels);
  Result<void> read_old_runs(std::span<Rgbe> pixels);

  std::span<const uint8_t> rest_;
  const std::string& name_;
  std::array<double, 3> divisor_ = {1.0, 1.0, 1.0};
};

Error HdrReader::bad(std::string reason) const {
  std::ranges::replace_if(
      reason, [](char c) { return c < ' ' || c > '~'; }, '?');
  return {ErrorKind::input, name_ + ": not a usable Radiance picture: " + reason};
}

// A line without its end; none when the file ends before.
std::optional<std::string_view> HdrReader::line() {
  constexpr size_t kLongest = 4096;
  const auto end = std::find(rest_.begin(), rest_.begin() + std::min(rest_.size(), kLongest), '\n');
  if (end == rest_.end() || *end != '\n') return std::nullopt;
  const size_t length = static_cast<size_t>(end - rest_.begin());
  std::string_view text(reinterpret_cast<const char*>(rest_.data()), length);
  rest_ = rest_.subspan(length + 1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::optional<uint8_t> HdrReader::byte() {
  if (rest_.empty()) return std::nullopt;
  const uint8_t value = rest_.front();
  rest_ = rest_.subspan(1);
  return value;
}

// Numbers that were multiplied into the samples; one stands for all three channels.
Result<void> HdrReader::read_factors(std::string_view values, size_t count, const char* what) {
  std::array<double, 3> factors = {};
  const char* at = values.data();
  const char* end = at + values.size();
  for (size_t i = 0; i < count; ++i) {
    while (at < end && *at == ' ') ++at;
    const auto [stop, failure] = std::from_chars(at, end, factors[i]);
    if (failure != std::errc() || !(factors[i] > 1e-30 && factors[i] < 1e30))
      return bad(std::string("its ") + what + " is not a number above 0");
    at = stop;
  }
  for (size_t c = 0; c < 3; ++c) divisor_[c] *= factors[count == 1 ? 0 : c];
  return {};
}

Result<void> HdrReader::read_header() {
  const auto first = line();
  if (!first || !first->starts_with(kSignature)) return bad("it does not start with '#?'");
  for (;;) {
    const auto entry = line();
    if (!entry) return bad("its header is cut short");
    if (entry->empty()) break;
    const auto value_of = [&](std::string_view key) -> std::optional<std::string_view> {
      if (!entry->starts_with(key)) return std::nullopt;
      return entry->substr(key.size());
    };
    if (const auto format = value_of("FORMAT=")) {
      if (*format == "32-bit_rle_xyze") return bad("colours as XYZE are not supported; use RGBE");
      if (*format != "32-bit_rle_rgbe")
        return bad("its format is " + std::string(*format) + ", not 32-bit_rle_rgbe");
    } else if (const auto exposure = value_of("EXPOSURE=")) {
      LUEUR_TRY_VOID(read_factors(*exposure, 1, "EXPOSURE"));
    } else if (const auto correction = value_of("COLORCORR=")) {
      LUEUR_TRY_VOID(read_factors(*correction, 3, "COLORCORR"));
    }
  }
  for (const double factor : divisor_)
    if (!(factor > 1e-30 && factor < 1e30)) return bad("its EXPOSURE is out of range");
  return {};
}

// "-Y 512 +X 1024": the axis of the scan lines' order first, then that along them. -Y is downwards.
Result<Layout> HdrReader::read_layout() {
  const auto text = line();
  if (!text) return bad("its size is missing");
  struct Axis {
    char name = 0;
    bool grows = false;
    uint32_t length = 0;
  };
  std::array<Axis, 2> axes;
  const char* at = text->data();
  const char* end = at + text->size();
  const auto skip_spaces = [&] {
    while (at < end && *at == ' ') ++at;
  };
  for (Axis& axis : axes) {
    skip_spaces();
    if (end - at < 3 || (at[0] != '-' && at[0] != '+') || (at[1] != 'X' && at[1] != 'Y'))
      return bad("its size is not told as in '-Y 512 +X 1024'");
    axis.grows = at[0] == '+';
    axis.name = at[1];
    at += 2;
    skip_spaces();
    const auto [stop, failure] = std::from_chars(at, end, axis.length);
    if (failure != std::errc()) return bad("its size is not a number");
    at = stop;
  }
  if (axes[0].name == axes[1].name) return bad("its size tells one axis twice");
  const bool rows = axes[0].name == 'Y';
  const Layout layout{axes[0].length, axes[1].length, rows, rows ? axes[1].grows : axes[0].grows,
                      rows ? axes[0].grows : axes[1].grows};
  const auto is_side = [](uint32_t side) { return side >= 1 && side <= kMaxHdrSide; };
  if (!is_side(layout.lines) || !is_side(layout.line_pixels) ||
      uint64_t{layout.lines} * layout.line_pixels > kMaxHdrPixels)
    return bad("it has " + std::to_string(layout.width()) + "x" + std::to_string(layout.height()) +
               " pixels, more than " + std::to_string(kMaxHdrSide) + " a side or " +
               std::to_string(kMaxHdrPixels) + " together; resize it");
  // A scan line has one pixel at least.
  if (rest_.size() / sizeof(Rgbe) < layout.lines) return bad("it is cut short");
  return layout;
}

// Each channel by itself: a count above 128 is a run, up to 128 so many single values.
Result<void> HdrReader::read_new_runs(std::span<Rgbe> pixels) {
  for (size_t c = 0; c < 4; ++c) {
    for (size_t x = 0; x < pixels.size();) {
      const auto code = byte();
      if (!code) return bad("it is cut short");
      const bool is_run = *code > 128;
      const size_t count = is_run ? *code - 128u : *code;
      if (count == 0 || count > pixels.size() - x) return bad("a run leads out of its scan line");
      std::optional<uint8_t> value;
      for (size_t i = 0; i < count; ++i) {
        if (i == 0 || !is_run) value = byte();
        if (!value) return bad("it is cut short");
        pixels[x++][c] = *value;
      }
    }
  }
  return {};
}

// Whole pixels; (1, 1, 1, n) repeats the last one n times, and such pixels in a row are the digits
// of the count, least first.
Result<void> HdrReader::read_old_runs(std::span<Rgbe> pixels) {
  uint32_t digits = 0;
  for (size_t x = 0; x < pixels.size();) {
    if (rest_.size() < sizeof(Rgbe)) return bad("it is cut short");
    Rgbe pixel;
    std::copy_n(rest_.begin(), sizeof(Rgbe), pixel.begin());
    rest_ = rest_.subspan(sizeof(Rgbe));
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      pixels[x++] = pixel;
      digits = 0;
      continue;
    }
    const uint64_t count = digits < 4 ? uint64_t{pixel[3]} << (8 * digits) : UINT64_MAX;
    if (x == 0 || count > pixels.size() - x) return bad("a run leads out of its scan line");
    std::fill_n(pixels.begin() + static_cast<std::ptrdiff_t>(x), count, pixels[x - 1]);
    x += count;
    ++digits;
  }
  return {};
}

Result<void> HdrReader::read_scan_line(std::span<Rgbe> pixels) {
  constexpr size_t kLeast = 8, kMost = 32767;  // pixels of a line in the new encoding
  const bool may_be_new = pixels.size() >= kLeast && pixels.size() <= kMost && rest_.size() >= 4;
  if (!may_be_new || rest_[0] != 2 || rest_[1] != 2 || rest_[2] >= 128)
    return read_old_runs(pixels);
  if (size_t{rest_[2]} * 256 + rest_[3] != pixels.size())
    return bad("a scan line has another length than the header tells");
  rest_ = rest_.subspan(4);
  return read_new_runs(pixels);
}

Result<ImageF> HdrReader::read() {
  LUEUR_TRY_VOID(read_header());
  LUEUR_TRY(layout, read_layout());
  ImageF image(layout.width(), layout.height(), 3);
  std::vector<Rgbe> pixels(layout.line_pixels);
  for (uint32_t i = 0; i < layout.lines; ++i) {
    LUEUR_TRY_VOID(read_scan_line(pixels));
    for (uint32_t k = 0; k < layout.line_pixels; ++k) {
      const uint32_t column = layout.lines_are_rows ? k : i, row = layout.lines_are_rows ? i : k;
      const uint32_t x = layout.x_grows ? column : image.width - 1 - column;
      const uint32_t y = layout.y_grows ? image.height - 1 - row : row;
      // The mantissas are 256ths; an exponent of 0 is black.
      const double scale = pixels[k][3] == 0 ? 0.0 : std::ldexp(1.0, pixels[k][3] - (128 + 8));
      for (uint32_t c = 0; c < 3; ++c)
        image.at(x, y, c) = static_cast<float>(std::min(pixels[k][c] * scale / divisor_[c],
                                                        double{std::numeric_limits<float>::max()}));
    }
  }
  return image;
}

}  // namespace

bool is_hdr(std::span<const uint8_t> bytes) {
  return bytes.size() >= kSignature.size() &&
         std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

Result<ImageF> decode_hdr(std::span<const uint8_t> bytes, const std::string& name) {
  try {
    return HdrReader(bytes, name).read();
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, name + ": memory ran out; use a smaller picture"};
  }
}

Result<ImageF> read_hdr(const std::filesystem::path& path) {
  LUEUR_TRY(bytes, read_file(path, kMaxFileBytes));
  return decode_hdr(bytes, path.string());
}

}  // namespace lueur
