// SPDX-License-Identifier: MIT
#include "limit_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "arguments.h"
#include "base/try.h"

namespace lueur::cli {
namespace {

struct Row {
  std::string_view name;
  std::variant<uint64_t LoadLimits::*, uint32_t LoadLimits::*> field;
  std::string_view unit;
  uint64_t max;
};

// Vertices and indices are counted in 32 bits, and JSON is compared by recursion.
constexpr Row kRows[] = {
    {"file-bytes", &LoadLimits::file_bytes, "bytes of all files of a scene", uint64_t{1} << 40},
    {"vertices", &LoadLimits::vertices, "of all meshes", UINT32_MAX / 2},
    {"indices", &LoadLimits::indices, "of all meshes", UINT32_MAX / 2},
    {"nodes", &LoadLimits::nodes, "of a scene", INT32_MAX},
    {"images", &LoadLimits::images, "textures of a scene", INT32_MAX},
    {"texture-side", &LoadLimits::texture_side_px, "pixels", 1u << 16},
    {"texture-bytes", &LoadLimits::texture_bytes, "of all textures, decoded", uint64_t{1} << 40},
    {"json-values", &LoadLimits::json_values, "of a file's JSON", uint64_t{1} << 32},
    {"json-depth", &LoadLimits::json_depth, "levels of a file's JSON", 1000}};

uint64_t value_of(const LoadLimits& limits, const Row& row) {
  return std::visit([&](auto field) { return uint64_t{limits.*field}; }, row.field);
}

std::string help() {
  const LoadLimits defaults;
  std::string text = "What a scene file may ask for; may be repeated. NAME (and its default):";
  for (const Row& row : kRows)
    text += "\n" + std::string(row.name) + " (" + std::to_string(value_of(defaults, row)) + "), " +
            std::string(row.unit);
  return text;
}

}  // namespace

Result<void> set_limit(LoadLimits& limits, const std::string& assignment) {
  LUEUR_TRY(parts, parse_assignment("--limit", assignment));
  const Row* row = std::ranges::find(kRows, std::string_view(parts.key), &Row::name);
  if (row == std::end(kRows)) {
    std::vector<std::string> names;
    for (const Row& known : kRows) names.emplace_back(known.name);
    return Error{ErrorKind::usage,
                 "--limit '" + parts.key + "': not a limit; there are " + joined(names)};
  }
  uint64_t value = 0;
  const char* end = parts.value.data() + parts.value.size();
  const auto [stop, failure] = std::from_chars(parts.value.data(), end, value);
  if (failure != std::errc() || stop != end || value > row->max)
    return Error{ErrorKind::usage, "--limit '" + assignment + "': " + parts.key +
                                       " is a whole number up to " + std::to_string(row->max)};
  std::visit(
      [&](auto field) {
        limits.*field = static_cast<std::remove_reference_t<decltype(limits.*field)>>(value);
      },
      row->field);
  return {};
}

void add_limit_option(CLI::App& command, LoadLimits& limits) {
  const auto set = [&limits](const std::string& assignment) {
    const auto done = set_limit(limits, assignment);
    if (!done.ok()) throw CLI::ValidationError(done.error().message);
  };
  command.add_option_function<std::string>("--limit", set, help())
      ->type_name("NAME=VALUE")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->trigger_on_parse();
}

}  // namespace lueur::cli
