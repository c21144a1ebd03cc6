// SPDX-License-Identifier: MIT
// From what a user typed to values, or to one line (ErrorKind::usage) that names the flag, what it
// was given, and what it takes.
#pragma once

#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "image/tone_map.h"
#include "lueur/image.h"
#include "lueur/result.h"

namespace lueur::cli {

inline constexpr uint32_t kMaxSide = 16384;  // pixels

// "1280x720"; each side from 1 to kMaxSide.
Result<Extent> parse_size(std::string_view flag, std::string_view text);

// A whole number in [min, max].
Result<uint32_t> parse_count(std::string_view flag, std::string_view text, uint32_t min,
                             uint32_t max);

// A finite decimal number in [-limit, limit].
Result<float> parse_real(std::string_view flag, std::string_view text, float limit);

// What --exposure says of the brightness at which a picture is shown.
struct ExposureChoice {
  std::optional<float> ev;  // stops to add
  bool is_metered = false;  // else without `ev`: the scene's own, metered only where it has none
};
// Stops, "auto" to meter, or "".
Result<ExposureChoice> parse_exposure(std::string_view text);
// The stops for `picture`, which is linear; `of_scene` is Scene::exposure_ev.
float exposure_ev(const ExposureChoice& choice, std::optional<float> of_scene,
                  const ImageF& picture);

Result<ToneMap> parse_tone_map(std::string_view text);

// "key=value", split at the first "=".
struct Assignment {
  std::string key;
  std::string value;
};
Result<Assignment> parse_assignment(std::string_view flag, std::string_view text);

// The parts of "a,b,c"; one more than there are separators, so "" has one.
std::vector<std::string> split(std::string_view text, char separator);

// As one word for a shell: in single quotes where anything in it is more than a plain character.
std::string shell_quoted(const std::string& text);

// "a, b, c"
std::string joined(const std::vector<std::string>& words);

// The row whose `name` this is; else an error that lists the names. `rows` outlive what is
// returned.
template <class Rows>
auto find_named(std::string_view flag, std::string_view text, const Rows& rows)
    -> Result<const std::ranges::range_value_t<Rows>*> {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    if (row.name == text) return &row;
    names.emplace_back(row.name);
  }
  return Error{ErrorKind::usage, std::string(flag) + " '" + std::string(text) +
                                     "': expected one of " + joined(names)};
}

}  // namespace lueur::cli
