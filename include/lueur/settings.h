// SPDX-License-Identifier: MIT
// A technique's settings as a table: one row a field, from which flags, sliders, JSON, range checks
// and documentation are made.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "lueur/result.h"

namespace lueur {

enum class SettingKind { integer, real, choice, toggle };

struct SettingInfo {
  std::string_view name;
  SettingKind kind = SettingKind::integer;
  double min = 0;  // inclusive; choices count from 0
  double max = 0;
  std::string_view unit;                      // "px", "samples", …; empty for none
  std::string_view summary;                   // one sentence
  std::span<const std::string_view> choices;  // of kind choice, in the order of the values
  // Field access in the settings structure that the table belongs to.
  double (*get)(const void* settings) = nullptr;
  void (*set)(void* settings, double value) = nullptr;
};

namespace detail {
template <class S, class T>
S owner_of(T S::*);
template <class S, class T>
T type_of(T S::*);
}  // namespace detail

// The row of one field: setting<&Settings::samples>("samples", 1, 256, "samples a pixel", "…").
template <auto Field>
constexpr SettingInfo setting(std::string_view name, double min, double max, std::string_view unit,
                              std::string_view summary,
                              std::span<const std::string_view> choices = {}) {
  using S = decltype(detail::owner_of(Field));
  using T = decltype(detail::type_of(Field));
  SettingInfo info{name, SettingKind::integer, min, max, unit, summary, choices, nullptr, nullptr};
  if (std::is_floating_point_v<T>) info.kind = SettingKind::real;
  if (std::is_enum_v<T>) info.kind = SettingKind::choice;
  if (std::is_same_v<T, bool>) info.kind = SettingKind::toggle;
  info.get = [](const void* s) { return static_cast<double>(static_cast<const S*>(s)->*Field); };
  info.set = [](void* s, double v) { static_cast<S*>(s)->*Field = static_cast<T>(v); };
  return info;
}

template <auto Field, size_t N>
constexpr SettingInfo choice(std::string_view name, const std::string_view (&choices)[N],
                             std::string_view summary) {
  return setting<Field>(name, 0, static_cast<double>(N - 1), "", summary, choices);
}

template <auto Field>
constexpr SettingInfo toggle(std::string_view name, std::string_view summary) {
  return setting<Field>(name, 0, 1, "", summary);
}

// Sets one field from text. Fails (ErrorKind::usage) on a name that is not in the table, on text
// that is no such value, and on a value out of range; the message lists what would be right.
Result<void> set_from_text(std::span<const SettingInfo> table, void* settings,
                           std::string_view name, std::string_view text);

// The value of one field as set_from_text() takes it.
std::string to_text(const SettingInfo& info, const void* settings);

// Fails on the first field whose value is out of range, for settings that were filled in by code.
Result<void> check_ranges(std::span<const SettingInfo> table, const void* settings);

}  // namespace lueur
