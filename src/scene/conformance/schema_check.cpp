// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "scene/conformance/json_read.h"
#include "scene/conformance/schema.h"

namespace lueur::conformance {
namespace {

std::string shown(double value) {
  std::string text = Json(value).dump();
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

// "0 to 6" for a run of numbers, "9728 or 9729" for others.
std::string shown(std::span<const int> numbers) {
  if (numbers.size() > 2 && numbers.back() - numbers.front() + 1 == int(numbers.size()))
    return std::to_string(numbers.front()) + " to " + std::to_string(numbers.back());
  std::string text;
  for (size_t i = 0; i < numbers.size(); ++i)
    text += (i == 0 ? "" : i + 1 == numbers.size() ? " or " : ", ") + std::to_string(numbers[i]);
  return text;
}

std::string shown(std::span<const std::string_view> texts) {
  std::string list;
  for (size_t i = 0; i < texts.size(); ++i)
    list += (i == 0 ? "" : i + 1 == texts.size() ? " or " : ", ") + std::string(texts[i]);
  return list;
}

const char* name_of(JsonType type) {
  switch (type) {
    case JsonType::boolean:
      return "true or false";
    case JsonType::integer:
      return "an integer";
    case JsonType::number:
      return "a number";
    case JsonType::text:
      return "a string";
    case JsonType::object:
      return "an object";
  }
  return "";
}

bool is_of(const Json& value, JsonType type) {
  switch (type) {
    case JsonType::boolean:
      return value.is_boolean();
    case JsonType::integer:
      return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
    case JsonType::number:
      return value.is_number();
    case JsonType::text:
      return value.is_string();
    case JsonType::object:
      return value.is_object();
  }
  return false;
}

class SchemaCheck {
 public:
  SchemaCheck(const JsonCursor& root, Findings& findings)
      : root_(&root.value()), findings_(&findings) {
    for (const Json& name : list(*root_, "extensionsUsed"))
      if (name.is_string()) declared_.insert(name.get_ref<const std::string&>());
  }

  void check_object(const JsonCursor& at, const ObjectRule& rule);

 private:
  void check_property(const JsonCursor& parent, const JsonCursor& at, const Property& property);
  void check_list(const JsonCursor& at, const Property& property);
  void check_value(const JsonCursor& at, const Property& property);
  void check_number(const JsonCursor& at, const Property& property);
  void check_extensions(const JsonCursor& at, const ObjectRule& holder);
  size_t size_of(std::string_view array) const;
  void add(const JsonCursor& at, std::string_view what) { findings_->add(at.path(), what); }

  const Json* root_;
  Findings* findings_;
  std::set<std::string, std::less<>> declared_;
};

void SchemaCheck::check_object(const JsonCursor& at, const ObjectRule& rule) {
  for (const Property& property : rule.properties) {
    if (at.has(property.name.data()))
      check_property(at, at.member(property.name.data()), property);
    else if (property.required)
      add(at, std::string(property.name) + " is missing");
  }
  if (!rule.one_of.empty()) {
    const auto count = std::count_if(rule.one_of.begin(), rule.one_of.end(),
                                     [&](std::string_view name) { return at.has(name.data()); });
    if (count != 1) add(at, "has to have exactly one of " + shown(rule.one_of));
  }
  if (at.has("extensions")) check_extensions(at, rule);
}

void SchemaCheck::check_property(const JsonCursor& parent, const JsonCursor& at,
                                 const Property& property) {
  if (!property.needs.empty() && !parent.has(property.needs.data()))
    add(at, "needs " + std::string(property.needs) + " beside it");
  if (property.is_list)
    check_list(at, property);
  else
    check_value(at, property);
}

void SchemaCheck::check_list(const JsonCursor& at, const Property& property) {
  const Json& values = at.value();
  if (!values.is_array()) return add(at, "has to be an array");
  if (values.empty()) return add(at, "must not be empty");
  if (property.items != 0 && values.size() != property.items)
    add(at, "has to have " + std::to_string(property.items) + " items, not " +
                std::to_string(values.size()));
  for (size_t i = 0; i < values.size(); ++i) check_value(at.item(i), property);
  if (!property.unique) return;
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::stable_sort(order, [&](size_t a, size_t b) { return values[a] < values[b]; });
  for (size_t i = 1; i < order.size(); ++i)
    if (values[order[i - 1]] == values[order[i]]) add(at.item(order[i]), "is in the list twice");
}

void SchemaCheck::check_value(const JsonCursor& at, const Property& property) {
  const Json& value = at.value();
  if (!is_of(value, property.type))
    return add(at, std::string("has to be ") + name_of(property.type));
  if (property.object) check_object(at, *property.object);
  if (value.is_number()) check_number(at, property);
  if (!value.is_string() || property.texts.empty()) return;
  const std::string& text = value.get_ref<const std::string&>();
  if (std::ranges::find(property.texts, text) == property.texts.end())
    add(at, in_quotes(text) + " is not " + shown(property.texts));
}

void SchemaCheck::check_number(const JsonCursor& at, const Property& property) {
  const double value = at.value().get<double>();
  if (!property.index_into.empty()) {
    const size_t size = size_of(property.index_into);
    if (value < 0.0 || value >= static_cast<double>(size)) {
      const std::string_view things =
          property.index_into.substr(property.index_into.rfind('/') + 1);
      add(at,
          shown(value) + " is not below the " + std::to_string(size) + " " + std::string(things));
    }
    return;
  }
  const bool below = property.above_min ? value <= property.min : value < property.min;
  if (below)
    add(at, shown(value) + " has to be " + (property.above_min ? "more than " : "at least ") +
                shown(property.min));
  if (value > property.max) add(at, shown(value) + " has to be at most " + shown(property.max));
  if (property.multiple_of > 1 && std::fmod(value, property.multiple_of) != 0.0)
    add(at, shown(value) + " is not a multiple of " + std::to_string(property.multiple_of));
  const auto is_value = [value](int allowed) { return allowed == value; };
  if (!property.numbers.empty() && std::ranges::none_of(property.numbers, is_value))
    add(at, shown(value) + " is not " + (property.numbers.size() > 4 ? "one of " : "") +
                shown(property.numbers));
}

void SchemaCheck::check_extensions(const JsonCursor& holder, const ObjectRule& rule) {
  const JsonCursor extensions = holder.member("extensions");
  if (!extensions.value().is_object()) return add(extensions, "has to be an object");
  for (const auto& item : extensions.value().items()) {
    const std::string& name = item.key();
    const JsonCursor at = extensions.member(name.c_str());
    if (!at.value().is_object()) {
      add(at, "has to be an object");
      continue;
    }
    if (!declared_.contains(name)) {
      add(at, "is not listed in extensionsUsed");
      continue;
    }
    const auto rules = extension_rules();
    const auto of_name = [&](const ExtensionRule& row) { return row.name == name; };
    const auto here = [&](const ExtensionRule& row) {
      return row.name == name && row.place == rule.name;
    };
    const auto found = std::ranges::find_if(rules, here);
    if (found != rules.end())
      check_object(at, *found->rule);
    else if (std::ranges::any_of(rules, of_name))
      add(at, "this extension has no place in such an object");
  }
}

size_t SchemaCheck::size_of(std::string_view array) const {
  if (!array.starts_with('/')) return list(*root_, array).size();
  const size_t last = array.rfind('/');
  const std::string_view extension = array.substr(12, last - 12);  // behind "/extensions/"
  return list(member(*root_, {"extensions", extension}), array.substr(last + 1)).size();
}

}  // namespace

void check_schema(const JsonCursor& root, Findings& findings) {
  SchemaCheck(root, findings).check_object(root, kRootRule);
}

}  // namespace lueur::conformance
