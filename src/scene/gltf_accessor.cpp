// SPDX-License-Identifier: MIT
#include "scene/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "base/try.h"
#include "scene/scene.h"

namespace lueur {
namespace {

// Accessors may imply zeros without storing them; this many at most.
constexpr uint64_t kMaxImpliedElements = uint64_t{1} << 20;

enum class Component : uint32_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126,
};

// One strided run of elements inside a buffer view; already known to lie within it.
struct Run {
  const uint8_t* first = nullptr;
  uint64_t stride = 0;
  uint64_t count = 0;
};

struct Layout {
  uint64_t count = 0;
  uint32_t components = 0;
  Component component = Component::float32;
  bool normalized = false;
};

uint32_t byte_size(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8:
      return 1;
    case Component::int16:
    case Component::uint16:
      return 2;
    case Component::uint32:
    case Component::float32:
      return 4;
  }
  return 0;
}

Result<Component> read_component(const JsonCursor& at) {
  LUEUR_TRY(type, at.required_count("componentType", std::numeric_limits<uint32_t>::max()));
  const Component component = static_cast<Component>(type);
  if (byte_size(component) == 0)
    return at.error("componentType", std::to_string(type) + " is not a component type of glTF");
  return component;
}

Result<Layout> read_layout(const GltfFile& file, const JsonCursor& at) {
  Layout layout;
  LUEUR_TRY(component, read_component(at));
  layout.component = component;
  LUEUR_TRY(count,
            at.required_count("count", std::max(file.limits().vertices, file.limits().indices)));
  layout.count = count;
  if (count == 0) return at.error("count", "has to be 1 or more");
  LUEUR_TRY(normalized, at.boolean("normalized", false));
  layout.normalized = normalized;
  LUEUR_TRY(type, at.text("type", ""));
  if (type == "SCALAR") layout.components = 1;
  if (type == "VEC2") layout.components = 2;
  if (type == "VEC3") layout.components = 3;
  if (type == "VEC4") layout.components = 4;
  // With four bytes a number, a matrix' columns follow each other without gaps.
  if (type == "MAT4" && component == Component::float32) layout.components = 16;
  if (layout.components == 0)
    return at.error("type", in_quotes(type) + " is not SCALAR, VEC2, VEC3, VEC4 or a float MAT4");
  return layout;
}

// Locates `count` elements of `element_bytes` in the view that `at` names.
Result<Run> locate(const GltfFile& file, const JsonCursor& at, uint64_t count,
                   uint64_t element_bytes) {
  LUEUR_TRY(index, at.required_index("bufferView", file.size_of("bufferViews"), "buffer views"));
  LUEUR_TRY(view, file.view(index));
  LUEUR_TRY(offset, at.count("byteOffset", 0, file.limits().file_bytes));
  const uint64_t stride = view.stride != 0 ? view.stride : element_bytes;
  if (stride < element_bytes)
    return at.error("bufferView", "stride " + std::to_string(stride) +
                                      " of the buffer view is "
                                      "less than an element's " +
                                      std::to_string(element_bytes) + " bytes; re-export the file");
  // No overflow: count and offset are capped by LoadLimits, the stride by glTF's 252 bytes.
  const uint64_t needed = offset + (count - 1) * stride + element_bytes;
  if (needed > view.bytes.size())
    return at.error(std::to_string(count) + " elements need " + std::to_string(needed) +
                    " bytes, the buffer view has " + std::to_string(view.bytes.size()) +
                    "; re-export the file");
  return Run{view.bytes.data() + offset, stride, count};
}

template <class T>
T load(const uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));  // elements need not be aligned
  return value;
}

// The integer-to-float rules of glTF 2.0, section 3.11 (accessor data types).
template <class Source>
float to_float(Source value, bool normalized) {
  if constexpr (std::is_same_v<Source, float>) {
    return value;
  } else {
    if (!normalized) return static_cast<float>(value);
    const float scaled =
        static_cast<float>(value) / static_cast<float>(std::numeric_limits<Source>::max());
    return std::max(scaled, -1.0f);
  }
}

template <class Source>
void gather(const Run& run, const Layout& layout, float* out) {
  for (uint64_t i = 0; i < run.count; ++i) {
    const uint8_t* element = run.first + i * run.stride;
    for (uint32_t c = 0; c < layout.components; ++c)
      *out++ = to_float(load<Source>(element + c * sizeof(Source)), layout.normalized);
  }
}

void gather_any(const Run& run, const Layout& layout, float* out) {
  switch (layout.component) {
    case Component::int8:
      return gather<int8_t>(run, layout, out);
    case Component::uint8:
      return gather<uint8_t>(run, layout, out);
    case Component::int16:
      return gather<int16_t>(run, layout, out);
    case Component::uint16:
      return gather<uint16_t>(run, layout, out);
    case Component::uint32:
      return gather<uint32_t>(run, layout, out);
    case Component::float32:
      return gather<float>(run, layout, out);
  }
}

// Unsigned integers of 1, 2 or 4 bytes, as for indices.
std::vector<uint32_t> gather_unsigned(const Run& run, Component component) {
  std::vector<uint32_t> values(run.count);
  for (uint64_t i = 0; i < run.count; ++i) {
    const uint8_t* element = run.first + i * run.stride;
    if (component == Component::uint8) values[i] = *element;
    if (component == Component::uint16) values[i] = load<uint16_t>(element);
    if (component == Component::uint32) values[i] = load<uint32_t>(element);
  }
  return values;
}

Result<void> require_unsigned(const JsonCursor& at, Component component) {
  if (component == Component::uint8 || component == Component::uint16 ||
      component == Component::uint32)
    return {};
  return at.error("componentType", "has to be an unsigned integer type here");
}

// Where the sparse part of an accessor puts which new elements.
struct Sparse {
  std::vector<uint32_t> targets;  // ascending, each below the accessor's count
  Run values;
};

Result<Sparse> read_sparse(const GltfFile& file, const JsonCursor& at, const Layout& layout) {
  LUEUR_TRY(sparse, at.object("sparse"));
  LUEUR_TRY(count, sparse.required_count("count", layout.count));
  if (count == 0) return sparse.error("count", "has to be 1 or more");
  LUEUR_TRY(indices, sparse.object("indices"));
  LUEUR_TRY(component, read_component(indices));
  LUEUR_TRY_VOID(require_unsigned(indices, component));
  LUEUR_TRY(index_run, locate(file, indices, count, byte_size(component)));
  LUEUR_TRY(values, sparse.object("values"));
  LUEUR_TRY(value_run,
            locate(file, values, count, uint64_t{layout.components} * byte_size(layout.component)));

  Sparse result{gather_unsigned(index_run, component), value_run};
  for (size_t i = 0; i < result.targets.size(); ++i) {
    if (result.targets[i] >= layout.count)
      return indices.error(std::to_string(result.targets[i]) + " is not below the accessor's " +
                           std::to_string(layout.count) + " elements; re-export the file");
    if (i > 0 && result.targets[i] <= result.targets[i - 1])
      return indices.error("the indices do not ascend; re-export the file");
  }
  return result;
}

// Elements that no buffer view holds are zeros: few words ask for much memory.
Result<void> check_implied(const JsonCursor& at, const Layout& layout) {
  if (layout.count <= kMaxImpliedElements) return {};
  return at.error("count", std::to_string(layout.count) +
                               " elements without a buffer view are more than the limit of " +
                               std::to_string(kMaxImpliedElements));
}

}  // namespace

Result<AccessorShape> accessor_shape(const GltfFile& file, int32_t index) {
  const JsonCursor top = file.root();
  LUEUR_TRY(accessors, top.array("accessors"));
  LUEUR_TRY(at, accessors.element(static_cast<size_t>(index)));
  LUEUR_TRY(layout, read_layout(file, at));
  LUEUR_TRY(view, at.index("bufferView", file.size_of("bufferViews"), "buffer views"));
  const bool has_data = view == kNone ? at.has("sparse") : file.view_has_data(view);
  return AccessorShape{layout.count, layout.components, has_data};
}

Result<std::vector<float>> read_floats(const GltfFile& file, int32_t index) {
  const JsonCursor top = file.root();
  LUEUR_TRY(accessors, top.array("accessors"));
  LUEUR_TRY(at, accessors.element(static_cast<size_t>(index)));
  LUEUR_TRY(layout, read_layout(file, at));
  const uint64_t element_bytes = uint64_t{layout.components} * byte_size(layout.component);
  if (layout.component == Component::uint32 && layout.normalized)
    return at.error("normalized", "32-bit integers cannot be normalized");

  // Check every range before taking memory for the values.
  Run run;
  if (at.has("bufferView")) {
    LUEUR_TRY(located, locate(file, at, layout.count, element_bytes));
    run = located;
  } else {
    LUEUR_TRY_VOID(check_implied(at, layout));
  }
  Sparse sparse;
  if (at.has("sparse")) {
    LUEUR_TRY(read, read_sparse(file, at, layout));
    sparse = std::move(read);
  }

  std::vector<float> values(layout.count * layout.components);
  gather_any(run, layout, values.data());
  // Put the sparse elements over the others, one at a time: their places are scattered.
  for (size_t i = 0; i < sparse.targets.size(); ++i) {
    const Run one{sparse.values.first + i * sparse.values.stride, 0, 1};
    gather_any(one, layout, values.data() + size_t{sparse.targets[i]} * layout.components);
  }
  return values;
}

Result<std::vector<uint32_t>> read_unsigned(const GltfFile& file, int32_t index) {
  const JsonCursor top = file.root();
  LUEUR_TRY(accessors, top.array("accessors"));
  LUEUR_TRY(at, accessors.element(static_cast<size_t>(index)));
  LUEUR_TRY(layout, read_layout(file, at));
  LUEUR_TRY_VOID(require_unsigned(at, layout.component));
  if (layout.components != 1) return at.error("type", "has to be SCALAR here");
  std::vector<uint32_t> values;
  if (at.has("bufferView")) {
    LUEUR_TRY(run, locate(file, at, layout.count, byte_size(layout.component)));
    values = gather_unsigned(run, layout.component);
  } else {
    LUEUR_TRY_VOID(check_implied(at, layout));
    values.resize(layout.count);
  }
  if (!at.has("sparse")) return values;
  LUEUR_TRY(sparse, read_sparse(file, at, layout));
  const std::vector<uint32_t> replaced = gather_unsigned(sparse.values, layout.component);
  for (size_t i = 0; i < sparse.targets.size(); ++i) values[sparse.targets[i]] = replaced[i];
  return values;
}

}  // namespace lueur
