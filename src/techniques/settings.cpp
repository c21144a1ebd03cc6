// SPDX-License-Identifier: MIT
#include "lueur/settings.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace lueur {
namespace {

std::string number(double value) {
  char text[32];
  const int length = std::snprintf(text, sizeof(text), "%.9g", value);
  return std::string(text, static_cast<size_t>(length));
}

std::string allowed(const SettingInfo& info) {
  if (info.kind == SettingKind::toggle) return "true or false";
  if (info.kind == SettingKind::choice) {
    std::string list;
    for (std::string_view choice : info.choices)
      list += (list.empty() ? "" : ", ") + std::string(choice);
    return "one of " + list;
  }
  std::string range = number(info.min) + " to " + number(info.max);
  if (!info.unit.empty()) range += " " + std::string(info.unit);
  return (info.kind == SettingKind::integer ? "a whole number, " : "a number, ") + range;
}

Error bad_value(const SettingInfo& info, std::string_view text) {
  return {ErrorKind::usage,
          std::string(info.name) + "=" + std::string(text) + ": takes " + allowed(info)};
}

// The value that `text` stands for, or NaN.
double parse(const SettingInfo& info, std::string_view text) {
  const double none = std::nan("");
  if (info.kind == SettingKind::toggle) {
    if (text == "true" || text == "1" || text == "on") return 1;
    if (text == "false" || text == "0" || text == "off") return 0;
    return none;
  }
  if (info.kind == SettingKind::choice) {
    for (size_t i = 0; i < info.choices.size(); ++i)
      if (info.choices[i] == text) return static_cast<double>(i);
    return none;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return none;
  if (info.kind == SettingKind::integer && value != std::floor(value)) return none;
  return value;
}

bool in_range(const SettingInfo& info, double value) {
  return value >= info.min && value <= info.max;  // false for NaN
}

}  // namespace

Result<void> set_from_text(std::span<const SettingInfo> table, void* settings,
                           std::string_view name, std::string_view text) {
  std::string names;
  for (const SettingInfo& info : table) {
    names += (names.empty() ? "" : ", ") + std::string(info.name);
    if (info.name != name) continue;
    const double value = parse(info, text);
    if (!in_range(info, value)) return bad_value(info, text);
    info.set(settings, value);
    return {};
  }
  return Error{ErrorKind::usage, std::string(name) + ": no such setting; there is " + names};
}

std::string to_text(const SettingInfo& info, const void* settings) {
  const double value = info.get(settings);
  if (info.kind == SettingKind::toggle) return value != 0 ? "true" : "false";
  if (info.kind == SettingKind::choice) {
    const auto index = static_cast<size_t>(value);
    return index < info.choices.size() ? std::string(info.choices[index]) : number(value);
  }
  return number(value);
}

Result<void> check_ranges(std::span<const SettingInfo> table, const void* settings) {
  for (const SettingInfo& info : table)
    if (!in_range(info, info.get(settings))) return bad_value(info, to_text(info, settings));
  return {};
}

}  // namespace lueur
