// SPDX-License-Identifier: MIT
#include "scene/conformance/json_read.h"

#include <cmath>

namespace lueur::conformance {
namespace {

const Json kNull;
const Json kEmptyList = Json::array();

}  // namespace

const Json& member(const Json& object, std::string_view key) {
  if (!object.is_object()) return kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

const Json& member(const Json& object, std::initializer_list<std::string_view> path) {
  const Json* at = &object;
  for (const std::string_view key : path) at = &member(*at, key);
  return *at;
}

const Json& list(const Json& object, std::string_view key) {
  const Json& value = member(object, key);
  return value.is_array() ? value : kEmptyList;
}

std::optional<uint64_t> whole_number(const Json& value) {
  if (value.is_number_unsigned()) return value.get<uint64_t>();
  constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
  if (!value.is_number_float()) return std::nullopt;
  const double real = value.get<double>();
  // Accept 3.0 for 3, as some exporters write it.
  if (!(real >= 0.0 && real < kExactIntegers && real == std::floor(real))) return std::nullopt;
  return static_cast<uint64_t>(real);
}

std::optional<uint64_t> whole_number(const Json& object, std::string_view key) {
  return whole_number(member(object, key));
}

std::optional<double> real_number(const Json& object, std::string_view key) {
  const Json& value = member(object, key);
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

std::string_view text(const Json& object, std::string_view key) {
  const Json& value = member(object, key);
  if (!value.is_string()) return {};
  return value.get_ref<const std::string&>();
}

std::optional<size_t> index_below(const Json& object, std::string_view key, size_t size) {
  const std::optional<uint64_t> number = whole_number(object, key);
  if (!number || *number >= size) return std::nullopt;
  return static_cast<size_t>(*number);
}

std::string path_to(std::string_view list, size_t index) {
  return std::string(list) + '[' + std::to_string(index) + ']';
}

std::string path_to(const std::string& parent, std::string_view list, size_t index) {
  return parent + '.' + path_to(list, index);
}

std::string path_to(const std::string& parent, std::string_view key) {
  return parent + '.' + std::string(key);
}

}  // namespace lueur::conformance
