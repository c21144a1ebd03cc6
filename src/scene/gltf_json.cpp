// SPDX-License-Identifier: MIT
#include "scene/gltf_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/try.h"
#include "scene/scene.h"

namespace lueur {
namespace {

const Json kEmptyObject = Json::object();
const Json kEmptyArray = Json::array();

std::string index_text(size_t index) {
  std::string text = "[";
  text += std::to_string(index);
  text += ']';
  return text;
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr size_t kMaxLength = 60;
  std::string out;
  for (const char c : text.substr(0, kMaxLength)) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    out += control ? '?' : c;
  }
  if (text.size() > kMaxLength) out += "...";
  return out;
}

std::string in_quotes(std::string_view text) {
  std::string out = "'";
  out += printable(text);
  out += '\'';
  return out;
}

Result<Json> parse_json(std::string_view text, const std::string& file, uint32_t max_depth,
                        uint64_t max_values) {
  // Count brackets and values outside strings first: the tree takes far more memory than its text.
  uint32_t depth = 0;
  uint64_t values = 1;
  bool in_string = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '[' || c == '{') {
      ++values;
      if (++depth > max_depth)
        return Error{ErrorKind::input, file + ": JSON nested deeper than " +
                                           std::to_string(max_depth) + " levels at byte " +
                                           std::to_string(i) +
                                           "; no glTF needs that, re-export the file"};
    }
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (c == ',') ++values;
  }
  if (values > max_values)
    return Error{ErrorKind::input, file + ": more than " + std::to_string(max_values) +
                                       " JSON values; keep bulk data in buffers"};

  try {
    Json json = Json::parse(text.begin(), text.end());
    if (!json.is_object())
      return Error{ErrorKind::input, file + ": not a glTF file: the JSON is not an object"};
    return json;
  } catch (const Json::parse_error& failure) {
    return Error{ErrorKind::input, file + ": not valid JSON at byte " +
                                       std::to_string(failure.byte) + "; re-export the file"};
  } catch (const Json::exception&) {
    return Error{ErrorKind::input, file + ": the JSON holds a number that is out of range"};
  }
}

std::optional<std::string_view> find_duplicate_key(std::string_view text) {
  std::vector<std::string_view> keys;  // of all objects that are open, the outer ones first
  std::vector<size_t> first_keys;      // where each of them starts
  std::string_view last_string;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') {
      const size_t start = ++i;
      while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
      last_string = text.substr(start, i - start);
    } else if (c == ':') {
      keys.push_back(last_string);
    } else if (c == '{') {
      first_keys.push_back(keys.size());
    } else if (c == '}' && !first_keys.empty()) {
      const auto first = keys.begin() + static_cast<std::ptrdiff_t>(first_keys.back());
      std::sort(first, keys.end());
      const auto twice = std::adjacent_find(first, keys.end());
      if (twice != keys.end()) return *twice;
      keys.erase(first, keys.end());
      first_keys.pop_back();
    }
  }
  return std::nullopt;
}

const Json* JsonCursor::find(const char* key) const {
  if (!value_->is_object()) return nullptr;
  const auto found = value_->find(key);
  return found == value_->end() ? nullptr : &*found;
}

Result<JsonCursor> JsonCursor::object(const char* key) const& {
  const Json* value = find(key);
  if (value && !value->is_object()) return error(key, "has to be an object; re-export the file");
  return JsonCursor(value ? *value : kEmptyObject, *this, key, 0);
}

Result<JsonCursor> JsonCursor::array(const char* key) const& {
  const Json* value = find(key);
  if (value && !value->is_array()) return error(key, "has to be an array; re-export the file");
  return JsonCursor(value ? *value : kEmptyArray, *this, key, 0);
}

Result<JsonCursor> JsonCursor::element(size_t index) const& {
  const JsonCursor cursor((*value_)[index], *this, nullptr, index);
  if (!cursor.value_->is_object()) return cursor.error("has to be an object; re-export the file");
  return cursor;
}

Result<bool> JsonCursor::boolean(const char* key, bool fallback) const {
  const Json* value = find(key);
  if (!value) return fallback;
  if (!value->is_boolean()) return error(key, "has to be true or false");
  return value->get<bool>();
}

Result<float> JsonCursor::number(const char* key, float fallback) const {
  const Json* value = find(key);
  if (!value) return fallback;
  if (!value->is_number()) return error(key, "has to be a number");
  const double number = value->get<double>();
  if (!(std::abs(number) <= double{std::numeric_limits<float>::max()}))
    return error(key, "is out of the range of a 32-bit float");
  return static_cast<float>(number);
}

Result<std::string> JsonCursor::text(const char* key, const std::string& fallback) const {
  const Json* value = find(key);
  if (!value) return fallback;
  if (!value->is_string()) return error(key, "has to be a string");
  return value->get_ref<const std::string&>();
}

Result<uint64_t> JsonCursor::integer(const Json& value, const std::string& at, uint64_t max) const {
  constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
  uint64_t number = 0;
  if (value.is_number_unsigned()) {
    number = value.get<uint64_t>();
  } else {
    // Accept 3.0 for 3, as some exporters write it.
    const double real = value.is_number_float() ? value.get<double>() : -1.0;
    if (!(real >= 0.0 && real < kExactIntegers && real == std::floor(real)))
      return error_at(at, "has to be an integer of 0 or more");
    number = static_cast<uint64_t>(real);
  }
  if (number > max)
    return error_at(at,
                    std::to_string(number) + " is more than the limit of " + std::to_string(max));
  return number;
}

Result<uint64_t> JsonCursor::count(const char* key, uint64_t fallback, uint64_t max) const {
  const Json* value = find(key);
  if (!value) return fallback;
  return integer(*value, path_of(key), max);
}

Result<uint64_t> JsonCursor::required_count(const char* key, uint64_t max) const {
  if (!find(key)) return error(key, "is missing; re-export the file");
  return count(key, 0, max);
}

Result<bool> JsonCursor::numbers(const char* key, std::span<float> values) const {
  const Json* value = find(key);
  if (!value) return false;
  if (!value->is_array() || value->size() != values.size())
    return error(key, "has to be an array of " + std::to_string(values.size()) + " numbers");
  for (size_t i = 0; i < values.size(); ++i) {
    const Json& element = (*value)[i];
    const double number = element.is_number() ? element.get<double>() : HUGE_VAL;
    if (!(std::abs(number) <= double{std::numeric_limits<float>::max()}))
      return error_at(path_of(key) + index_text(i), "has to be a number in a 32-bit float's range");
    values[i] = static_cast<float>(number);
  }
  return true;
}

Result<int32_t> JsonCursor::index(const char* key, size_t size, const char* things) const {
  const Json* value = find(key);
  if (!value) return kNone;
  LUEUR_TRY(number, integer(*value, path_of(key), std::numeric_limits<uint64_t>::max()));
  if (number >= size || number > std::numeric_limits<int32_t>::max())
    return error(key, std::to_string(number) + " is not below the " + std::to_string(size) + " " +
                          things + "; re-export the file");
  return static_cast<int32_t>(number);
}

Result<int32_t> JsonCursor::required_index(const char* key, size_t size, const char* things) const {
  if (!find(key)) return error(key, "is missing; re-export the file");
  return index(key, size, things);
}

Result<std::vector<int32_t>> JsonCursor::indices(const char* key, size_t size,
                                                 const char* things) const {
  std::vector<int32_t> list;
  LUEUR_TRY(values, array(key));
  list.reserve(values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    const std::string at = path_of(key) + index_text(i);
    LUEUR_TRY(number, integer((*values.value_)[i], at, std::numeric_limits<uint64_t>::max()));
    if (number >= size || number > std::numeric_limits<int32_t>::max())
      return error_at(at, std::to_string(number) + " is not below the " + std::to_string(size) +
                              " " + things + "; re-export the file");
    list.push_back(static_cast<int32_t>(number));
  }
  return list;
}

Result<std::vector<std::string>> JsonCursor::texts(const char* key) const {
  std::vector<std::string> list;
  LUEUR_TRY(values, array(key));
  for (size_t i = 0; i < values.size(); ++i) {
    const Json& value = (*values.value_)[i];
    if (!value.is_string()) return error_at(path_of(key) + index_text(i), "has to be a string");
    list.push_back(value.get<std::string>());
  }
  return list;
}

Error JsonCursor::error(const std::string& what) const {
  return error_at(path(), what);
}

Error JsonCursor::error(const char* key, const std::string& what) const {
  return error_at(path_of(key), what);
}

Error JsonCursor::error_at(const std::string& at, const std::string& what) const {
  return {ErrorKind::input, *file_ + ": " + (at.empty() ? "" : at + ": ") + what};
}

std::string JsonCursor::path() const {
  if (!parent_) return "";
  if (key_) return parent_->path_of(key_);
  return parent_->path() + index_text(index_);
}

std::string JsonCursor::path_of(const char* key) const {
  const std::string here = path();
  return here.empty() ? key : here + "." + key;
}

}  // namespace lueur
