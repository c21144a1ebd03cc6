// SPDX-License-Identifier: MIT
#include "scene/conformance/accessor_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "scene/conformance/json_read.h"

namespace lueur::conformance {
namespace {

struct TypeRow {
  std::string_view name;
  uint32_t rows;
  uint32_t columns;
};
constexpr std::array kTypes{TypeRow{"SCALAR", 1, 1}, TypeRow{"VEC2", 2, 1}, TypeRow{"VEC3", 3, 1},
                            TypeRow{"VEC4", 4, 1},   TypeRow{"MAT2", 2, 2}, TypeRow{"MAT3", 3, 3},
                            TypeRow{"MAT4", 4, 4}};

uint32_t bytes_of(uint64_t component) {
  switch (component) {
    case kInt8:
    case kUint8:
      return 1;
    case kInt16:
    case kUint16:
      return 2;
    case kUint32:
    case kFloat32:
      return 4;
    default:
      return 0;
  }
}

Accessor declared(const Json& json, size_t view_count) {
  Accessor accessor;
  const auto type = std::ranges::find(kTypes, text(json, "type"), &TypeRow::name);
  const uint64_t component = whole_number(json, "componentType").value_or(0);
  accessor.count = whole_number(json, "count").value_or(0);
  accessor.offset = whole_number(json, "byteOffset").value_or(0);
  accessor.view = index_below(json, "bufferView", view_count);
  accessor.has_bounds = member(json, "min").is_array() && member(json, "max").is_array();
  accessor.normalized = member(json, "normalized") == Json(true);
  accessor.component_bytes = bytes_of(component);
  if (type == kTypes.end() || accessor.component_bytes == 0 || accessor.count == 0) return accessor;
  accessor.type = type->name;
  accessor.component = static_cast<uint32_t>(component);
  accessor.rows = type->rows;
  accessor.components = type->rows * type->columns;
  const uint32_t column = type->rows * accessor.component_bytes;
  accessor.column_bytes = type->columns > 1 ? (column + 3) / 4 * 4 : column;
  accessor.element_bytes = accessor.column_bytes * type->columns;
  return accessor;
}

// An index of sparse elements.
uint32_t load_index(uint32_t component, const uint8_t* bytes) {
  uint32_t value = 0;
  for (uint32_t i = bytes_of(component); i-- > 0;) value = value << 8 | bytes[i];
  return value;
}

}  // namespace

AccessorTable::AccessorTable(const GltfFile& file) : file_(&file), root_(&file.json()) {
  const Json& list_of_accessors = list(*root_, "accessors");
  const Json& views = list(*root_, "bufferViews");
  for (const Json& json : list_of_accessors) accessors_.push_back(declared(json, views.size()));
  ranges_.resize(accessors_.size());

  // Read each byte a few times at most, however many accessors share it.
  constexpr uint64_t kPasses = 8, kSpare = uint64_t{1} << 20;
  components_left_ = file.buffer_bytes() * kPasses + kSpare;
}

std::optional<ElementRun> AccessorTable::run(size_t view, uint64_t offset, uint64_t count,
                                             uint64_t element_bytes, bool strided) const {
  const auto found = file_->view(static_cast<int32_t>(view));
  if (!found.ok()) return std::nullopt;
  const uint64_t stride = strided && found->stride != 0 ? found->stride : element_bytes;
  const uint64_t size = found->bytes.size();
  // Divide instead of multiplying: none of the numbers is to be trusted.
  if (count == 0 || stride < element_bytes || offset > size || element_bytes > size - offset ||
      count - 1 > (size - offset - element_bytes) / stride)
    return std::nullopt;
  return ElementRun{found->bytes.data() + offset, stride};
}

std::optional<AccessorTable::Elements> AccessorTable::elements(size_t index) {
  const Accessor& accessor = accessors_[index];
  const Json& sparse = member(list(*root_, "accessors")[index], "sparse");
  if (!accessor.known() || (!accessor.view && !sparse.is_object())) return std::nullopt;
  const uint64_t limit = std::max(file_->limits().vertices, file_->limits().indices);
  if (accessor.count > limit || accessor.count * accessor.components > components_left_)
    return std::nullopt;
  components_left_ -= accessor.count * accessor.components;

  Elements elements;
  if (accessor.view) {
    const auto base =
        run(*accessor.view, accessor.offset, accessor.count, accessor.element_bytes, true);
    if (!base) return std::nullopt;
    elements.base = *base;
  }
  if (!sparse.is_object()) return elements;

  const size_t view_count = list(*root_, "bufferViews").size();
  const Json& indices = member(sparse, "indices");
  const Json& values = member(sparse, "values");
  const auto index_view = index_below(indices, "bufferView", view_count);
  const auto value_view = index_below(values, "bufferView", view_count);
  const uint64_t count = whole_number(sparse, "count").value_or(0);
  const uint64_t component = whole_number(indices, "componentType").value_or(0);
  const bool is_index = component == kUint8 || component == kUint16 || component == kUint32;
  if (!index_view || !value_view || count > accessor.count || !is_index) return std::nullopt;
  const auto index_run = run(*index_view, whole_number(indices, "byteOffset").value_or(0), count,
                             bytes_of(component), false);
  const auto value_run = run(*value_view, whole_number(values, "byteOffset").value_or(0), count,
                             accessor.element_bytes, false);
  if (!index_run || !value_run) return std::nullopt;
  for (uint64_t i = 0; i < count; ++i) {
    const uint32_t target =
        load_index(static_cast<uint32_t>(component), index_run->first + i * index_run->stride);
    const bool ascends = i == 0 || target > elements.targets.back();
    if (target >= accessor.count || !ascends) return std::nullopt;
    elements.targets.push_back(target);
  }
  elements.sparse = *value_run;
  return elements;
}

// One component after the other, so that the smallest and the largest stay in registers.
template <class Component>
void AccessorTable::widen(const Accessor& accessor, const ElementRun& run, Range& range) {
  for (uint32_t i = 0; i < accessor.components; ++i) {
    const uint8_t* at = run.first + i / accessor.rows * accessor.column_bytes +
                        i % accessor.rows * sizeof(Component);
    Component min = std::numeric_limits<Component>::max();
    Component max = std::numeric_limits<Component>::lowest();
    bool finite = true;
    for (uint64_t element = 0; element < accessor.count; ++element, at += run.stride) {
      Component value;
      std::memcpy(&value, at, sizeof(Component));
      min = value < min ? value : min;
      max = value > max ? value : max;
      if constexpr (std::is_same_v<Component, float>) finite = finite && value - value == 0.0f;
    }
    range.min[i] = std::min(range.min[i], static_cast<double>(min));
    range.max[i] = std::max(range.max[i], static_cast<double>(max));
    range.finite = range.finite && finite;
  }
}

const std::optional<AccessorTable::Range>& AccessorTable::range(size_t index) {
  std::optional<std::optional<Range>>& known = ranges_[index];
  if (known) return *known;
  known.emplace();
  const std::optional<Elements> found = elements(index);
  if (!found) return *known;
  Range range;
  range.min.fill(std::numeric_limits<double>::infinity());
  range.max.fill(-std::numeric_limits<double>::infinity());
  const Accessor& accessor = accessors_[index];
  if (found->base.first && found->targets.empty()) {
    with_type(accessor.component, [&]<class T>(T) { widen<T>(accessor, found->base, range); });
  } else {
    const auto grow = [&](uint64_t, const double* values) {
      for (uint32_t i = 0; i < accessor.components; ++i) {
        range.min[i] = std::min(range.min[i], values[i]);
        range.max[i] = std::max(range.max[i], values[i]);
        range.finite = range.finite && std::isfinite(values[i]);
      }
      return true;
    };
    with_type(accessor.component, [&]<class T>(T) { walk<T>(accessor, *found, grow); });
  }
  *known = range;
  return *known;
}

}  // namespace lueur::conformance
