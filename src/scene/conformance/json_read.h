// SPDX-License-Identifier: MIT
// Reads of JSON whose types may be wrong: what is wrong reads as absent. The schema tells of it;
// the rules that use these functions go on with the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "scene/gltf_json.h"

namespace lueur::conformance {

// A member; null where there is none. `path` leads from object to object.
const Json& member(const Json& object, std::string_view key);
const Json& member(const Json& object, std::initializer_list<std::string_view> path);
inline bool has(const Json& object, std::string_view key) {
  return !member(object, key).is_null();
}

// A member that is an array of objects or values; empty where there is none.
const Json& list(const Json& object, std::string_view key);

std::optional<uint64_t> whole_number(const Json& value);
std::optional<uint64_t> whole_number(const Json& object, std::string_view key);
std::optional<double> real_number(const Json& object, std::string_view key);
std::string_view text(const Json& object, std::string_view key);
// A member that is an index below `size`.
std::optional<size_t> index_below(const Json& object, std::string_view key, size_t size);

// "meshes[3]", "meshes[3].primitives[0]", "meshes[3].primitives[0].mode"
std::string path_to(std::string_view list, size_t index);
std::string path_to(const std::string& parent, std::string_view list, size_t index);
std::string path_to(const std::string& parent, std::string_view key);

}  // namespace lueur::conformance
