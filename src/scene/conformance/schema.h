// SPDX-License-Identifier: MIT
// What the objects of a glTF 2.0 file may hold, as tables: one row for each property. The tables
// are schema_core.cpp and schema_extensions.cpp; check_schema() holds a document against them.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "scene/conformance/findings.h"
#include "scene/gltf_json.h"

namespace lueur::conformance {

enum class JsonType : uint8_t { boolean, integer, number, text, object };

struct ObjectRule;

struct Property {
  std::string_view name;
  JsonType type = JsonType::object;
  bool is_list = false;  // an array of such values, which must not be empty
  bool required = false;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  // `min` itself is not allowed
  uint32_t multiple_of = 1;
  uint32_t items = 0;            // how many a list has; 0: any number from 1
  bool unique = false;           // no item twice
  std::span<const int> numbers;  // the only ones allowed, if there are any
  std::span<const std::string_view> texts;
  std::string_view index_into;         // the root's array that an index counts in
  std::string_view needs;              // a property that has to be there, too
  const ObjectRule* object = nullptr;  // what an object holds

  // The same row with something changed, so that a row reads as a line.
  constexpr Property must() const {
    Property row = *this;
    row.required = true;
    return row;
  }
  constexpr Property list_of(uint32_t count = 0) const {
    Property row = *this;
    row.is_list = true;
    row.items = count;
    return row;
  }
  constexpr Property once() const {
    Property row = *this;
    row.unique = true;
    return row;
  }
  constexpr Property at_least(double value) const {
    Property row = *this;
    row.min = value;
    return row;
  }
  constexpr Property above(double value) const {
    Property row = at_least(value);
    row.above_min = true;
    return row;
  }
  constexpr Property at_most(double value) const {
    Property row = *this;
    row.max = value;
    return row;
  }
  constexpr Property step(uint32_t value) const {
    Property row = *this;
    row.multiple_of = value;
    return row;
  }
  constexpr Property along_with(std::string_view other) const {
    Property row = *this;
    row.needs = other;
    return row;
  }
};

struct ObjectRule {
  std::string_view name;  // as the places of extensions call it
  std::span<const Property> properties;
  // Exactly one of these has to be there, if there are any.
  std::span<const std::string_view> one_of = {};
};

// Where an extension may stand; it has one row for each place. An extension without a rule is a
// mere name (KHR_mesh_quantization) and stands nowhere.
struct ExtensionRule {
  std::string_view name;
  std::string_view place;
  const ObjectRule* rule = nullptr;
};

// Rows to begin with.
constexpr Property boolean(std::string_view name) {
  return {.name = name, .type = JsonType::boolean};
}
constexpr Property integer(std::string_view name) {
  return {.name = name, .type = JsonType::integer};
}
constexpr Property number(std::string_view name) {
  return {.name = name, .type = JsonType::number};
}
constexpr Property share(std::string_view name) {
  return number(name).at_least(0).at_most(1);
}
constexpr Property string(std::string_view name) {
  return {.name = name, .type = JsonType::text};
}
constexpr Property object(std::string_view name, const ObjectRule& rule) {
  return {.name = name, .type = JsonType::object, .object = &rule};
}
constexpr Property index(std::string_view name, std::string_view into) {
  return {.name = name, .type = JsonType::integer, .min = 0, .index_into = into};
}
constexpr Property one_of(std::string_view name, std::span<const int> numbers) {
  return {.name = name, .type = JsonType::integer, .numbers = numbers};
}
constexpr Property one_of(std::string_view name, std::span<const std::string_view> texts) {
  return {.name = name, .type = JsonType::text, .texts = texts};
}

// The tables.
extern const ObjectRule kRootRule;
extern const ObjectRule kTextureInfoRule;
std::span<const ExtensionRule> extension_rules();

// Holds the document at `root` against the tables: types, ranges, indices, what is required, and
// where extensions stand. Its depth is that of the tables, whatever the document.
void check_schema(const JsonCursor& root, Findings& findings);

}  // namespace lueur::conformance
