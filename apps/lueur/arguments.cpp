// SPDX-License-Identifier: MIT
#include "arguments.h"

#include <charconv>
#include <cmath>

#include "base/try.h"
#include "image/exposure.h"

namespace lueur::cli {
namespace {

// The whole text as a number; empty when it is none or does not fit.
template <class T>
std::optional<T> number(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

Error refuse(std::string_view flag, std::string_view text, const std::string& expected) {
  return {ErrorKind::usage,
          std::string(flag) + " '" + std::string(text) + "': expected " + expected};
}

}  // namespace

Result<Extent> parse_size(std::string_view flag, std::string_view text) {
  const size_t cross = text.find('x');
  if (cross != std::string_view::npos) {
    const auto width = number<uint32_t>(text.substr(0, cross));
    const auto height = number<uint32_t>(text.substr(cross + 1));
    const auto fits = [](uint32_t side) { return side >= 1 && side <= kMaxSide; };
    if (width && height && fits(*width) && fits(*height)) return Extent{*width, *height};
  }
  return refuse(
      flag, text,
      "WIDTHxHEIGHT in pixels, each from 1 to " + std::to_string(kMaxSide) + ", such as 1280x720");
}

Result<uint32_t> parse_count(std::string_view flag, std::string_view text, uint32_t min,
                             uint32_t max) {
  const auto value = number<uint32_t>(text);
  if (value && *value >= min && *value <= max) return *value;
  return refuse(flag, text,
                "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
}

Result<float> parse_real(std::string_view flag, std::string_view text, float limit) {
  const auto value = number<float>(text);
  if (value && std::isfinite(*value) && std::abs(*value) <= limit) return *value;
  const std::string bound = std::to_string(static_cast<int64_t>(limit));
  return refuse(flag, text, "a number from -" + bound + " to " + bound);
}

Result<ExposureChoice> parse_exposure(std::string_view text) {
  if (text.empty()) return ExposureChoice{};
  if (text == "auto") return ExposureChoice{.is_metered = true};
  const auto value = parse_real("--exposure", text, 64.0f);
  if (!value.ok()) return refuse("--exposure", text, "stops from -64 to 64, or auto");
  return ExposureChoice{.ev = *value};
}

float exposure_ev(const ExposureChoice& choice, std::optional<float> of_scene,
                  const ImageF& picture) {
  if (choice.ev) return *choice.ev;
  return of_scene && !choice.is_metered ? *of_scene : auto_exposure_ev(picture);
}

Result<ToneMap> parse_tone_map(std::string_view text) {
  LUEUR_TRY(row, find_named("--tone-map", text, kToneMapNames));
  return row->tone_map;
}

Result<Assignment> parse_assignment(std::string_view flag, std::string_view text) {
  const size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return refuse(flag, text, "key=value, such as samples=32");
  return Assignment{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (size_t end = 0; end != std::string_view::npos;) {
    end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end != std::string_view::npos) text.remove_prefix(end + 1);
  }
  return parts;
}

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

std::string shell_quoted(const std::string& text) {
  constexpr char kPlain[] =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,@+";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace lueur::cli
