// SPDX-License-Identifier: MIT
// JSON of a file that is not trusted: a parser with caps, and a cursor whose every read checks the
// type and range and names the file and the JSON path when it refuses.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lueur/result.h"

namespace lueur {

using Json = nlohmann::json;

// `text` as shown in a message: one line, printable, at most 60 characters.
std::string printable(std::string_view text);
// The same in single quotes.
std::string in_quotes(std::string_view text);

// Parses a JSON object. Fails on malformed text, on nesting deeper than `max_depth` and on more
// than `max_values` values; both are counted before any memory is taken.
Result<Json> parse_json(std::string_view text, const std::string& file, uint32_t max_depth,
                        uint64_t max_values);

// The first key, as it is written, that an object of a valid JSON text has twice.
std::optional<std::string_view> find_duplicate_key(std::string_view text);

// A place in a document. It points at its parent cursor, which must outlive it: keep cursors in
// local variables, from the root down.
class JsonCursor {
 public:
  JsonCursor(const Json& root, const std::string& file) : value_(&root), file_(&file) {}

  bool has(const char* key) const { return value_->is_object() && value_->contains(key); }
  size_t size() const { return value_->size(); }

  // A member; an absent one reads as empty.
  Result<JsonCursor> object(const char* key) const&;
  Result<JsonCursor> array(const char* key) const&;
  Result<JsonCursor> object(const char* key) const&& = delete;
  Result<JsonCursor> array(const char* key) const&& = delete;
  // An element of this array that has to be an object. `index` must be below size().
  Result<JsonCursor> element(size_t index) const&;
  Result<JsonCursor> element(size_t index) const&& = delete;

  // What stands here, whatever its type, and a member or element that is known to be there.
  const Json& value() const { return *value_; }
  JsonCursor member(const char* key) const& { return {value_->at(key), *this, key, 0}; }
  JsonCursor item(size_t index) const& { return {(*value_)[index], *this, nullptr, index}; }
  JsonCursor member(const char* key) const&& = delete;
  JsonCursor item(size_t index) const&& = delete;

  // A member of the given type; `fallback` if it is absent.
  Result<bool> boolean(const char* key, bool fallback) const;
  Result<float> number(const char* key, float fallback) const;
  Result<std::string> text(const char* key, const std::string& fallback) const;
  Result<uint64_t> count(const char* key, uint64_t fallback, uint64_t max) const;
  // Fills `values` from an array of exactly as many finite numbers; false if it is absent.
  Result<bool> numbers(const char* key, std::span<float> values) const;
  // An index below `size` of the things called `things`; kNone if it is absent.
  Result<int32_t> index(const char* key, size_t size, const char* things) const;
  Result<std::vector<int32_t>> indices(const char* key, size_t size, const char* things) const;
  Result<std::vector<std::string>> texts(const char* key) const;

  // The same for members that must be there.
  Result<uint64_t> required_count(const char* key, uint64_t max) const;
  Result<int32_t> required_index(const char* key, size_t size, const char* things) const;

  // "file: path[.key]: what"
  Error error(const std::string& what) const;
  Error error(const char* key, const std::string& what) const;
  std::string path() const;  // "meshes[3].primitives[0]"; empty at the root

 private:
  JsonCursor(const Json& value, const JsonCursor& parent, const char* key, size_t index)
      : value_(&value), file_(parent.file_), parent_(&parent), key_(key), index_(index) {}

  const Json* find(const char* key) const;
  Result<uint64_t> integer(const Json& value, const std::string& at, uint64_t max) const;
  Error error_at(const std::string& at, const std::string& what) const;
  std::string path_of(const char* key) const;

  const Json* value_;
  const std::string* file_;
  const JsonCursor* parent_ = nullptr;
  const char* key_ = nullptr;  // null for an array element
  size_t index_ = 0;
};

}  // namespace lueur
