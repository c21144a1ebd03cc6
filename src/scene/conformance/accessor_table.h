// SPDX-License-Identifier: MIT
// The accessors of a file as the rules need them: what each is declared to be, and one pass over
// its elements.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/gltf_file.h"

namespace lueur::conformance {

// Component types by their numbers in glTF.
inline constexpr uint32_t kInt8 = 5120, kUint8 = 5121, kInt16 = 5122, kUint16 = 5123,
                          kUint32 = 5125, kFloat32 = 5126;

inline constexpr size_t kMaxComponents = 16;

struct Accessor {
  std::string_view type;   // empty: type, component type or count make no sense
  uint32_t component = 0;  // one of the above
  uint32_t component_bytes = 0;
  uint32_t components = 0;    // 1 to 16
  uint32_t rows = 0;          // components of a column of a matrix; `components` otherwise
  uint32_t column_bytes = 0;  // columns of matrices start at multiples of 4 bytes
  uint32_t element_bytes = 0;
  uint64_t count = 0;
  uint64_t offset = 0;  // within the view
  bool normalized = false;
  bool has_bounds = false;  // min and max, both lists
  std::optional<size_t> view;

  bool known() const { return !type.empty(); }
  bool is_matrix() const { return rows != components; }
  bool is(std::string_view other_type, uint32_t other_component) const {
    return type == other_type && component == other_component;
  }
};

// Where elements lie in a buffer view; known to be within it.
struct ElementRun {
  const uint8_t* first = nullptr;
  uint64_t stride = 0;
};

class AccessorTable {
 public:
  explicit AccessorTable(const GltfFile& file);

  size_t size() const { return accessors_.size(); }
  const Accessor& operator[](size_t index) const { return accessors_[index]; }

  // The smallest and largest of each component, NaN left out, and whether all are finite. None
  // where the elements cannot be read. Computed once.
  struct Range {
    std::array<double, kMaxComponents> min{};
    std::array<double, kMaxComponents> max{};
    bool finite = true;
  };
  const std::optional<Range>& range(size_t index);

  // Calls visit(element, values) for each element as stored, sparse ones put in; `values` points at
  // its components. Stops where `visit` returns false. False if the elements cannot be read: they
  // are not all there, or the file makes so many accessors of its bytes that reading them all would
  // take long.
  template <class Visit>
  bool for_each(size_t index, const Visit& visit);

 private:
  struct Elements {
    ElementRun base;                // first: null where all elements are 0
    std::vector<uint32_t> targets;  // of the sparse elements, ascending
    ElementRun sparse;
  };
  std::optional<Elements> elements(size_t index);
  std::optional<ElementRun> run(size_t view, uint64_t offset, uint64_t count,
                                uint64_t element_bytes, bool strided) const;
  template <class Component>
  static void load(const Accessor& accessor, const uint8_t* element, double* values);
  template <class Component, class Visit>
  static void walk(const Accessor& accessor, const Elements& elements, const Visit& visit);
  template <class Component>
  static void widen(const Accessor& accessor, const ElementRun& run, Range& range);
  // Calls action(T()) with the type of a component: once for each accessor, not for each element.
  template <class Action>
  static void with_type(uint32_t component, Action action);

  const GltfFile* file_;
  const Json* root_;
  std::vector<Accessor> accessors_;
  std::vector<std::optional<std::optional<Range>>> ranges_;
  uint64_t components_left_ = 0;
};

template <class Component>
void AccessorTable::load(const Accessor& accessor, const uint8_t* element, double* values) {
  for (uint32_t first = 0; first < accessor.components; first += accessor.rows) {
    for (uint32_t row = 0; row < accessor.rows; ++row) {
      Component value;
      std::memcpy(&value, element + row * sizeof(Component), sizeof(Component));
      values[first + row] = static_cast<double>(value);
    }
    element += accessor.column_bytes;
  }
}

template <class Component, class Visit>
void AccessorTable::walk(const Accessor& accessor, const Elements& elements, const Visit& visit) {
  std::array<double, kMaxComponents> values{};
  size_t next_sparse = 0;
  for (uint64_t i = 0; i < accessor.count; ++i) {
    const bool is_sparse =
        next_sparse < elements.targets.size() && elements.targets[next_sparse] == i;
    if (is_sparse)
      load<Component>(accessor, elements.sparse.first + next_sparse++ * elements.sparse.stride,
                      values.data());
    else if (elements.base.first)
      load<Component>(accessor, elements.base.first + i * elements.base.stride, values.data());
    else
      values.fill(0.0);
    if (!visit(i, values.data())) return;
  }
}

template <class Visit>
bool AccessorTable::for_each(size_t index, const Visit& visit) {
  const std::optional<Elements> found = elements(index);
  if (!found) return false;
  const Accessor& accessor = accessors_[index];
  with_type(accessor.component, [&]<class T>(T) { walk<T>(accessor, *found, visit); });
  return true;
}

template <class Action>
void AccessorTable::with_type(uint32_t component, Action action) {
  switch (component) {
    case kInt8:
      return action(int8_t{});
    case kUint8:
      return action(uint8_t{});
    case kInt16:
      return action(int16_t{});
    case kUint16:
      return action(uint16_t{});
    case kUint32:
      return action(uint32_t{});
    default:
      return action(float{});
  }
}

}  // namespace lueur::conformance
