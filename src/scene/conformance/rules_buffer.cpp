// SPDX-License-Identifier: MIT
// Buffers, buffer views and accessors.
#include <algorithm>
#include <cmath>
#include <string>

#include "scene/conformance/rules.h"
#include "scene/gltf_uri.h"

namespace lueur::conformance {
namespace {

bool is_bounded_by(const Json& bound, double value, bool is_float) {
  if (!bound.is_number()) return false;
  const double declared = bound.get<double>();
  // Compare as the data are stored: a decimal text rarely is a float.
  return is_float ? static_cast<float>(declared) == static_cast<float>(value) : declared == value;
}

// The declared bounds have to be those of the data, exactly.
void check_bounds(Asset& asset, size_t index, const std::string& path) {
  const Json& json = asset.list_of("accessors")[index];
  const Accessor& accessor = asset.accessors[index];
  const bool is_float = accessor.component == kFloat32;
  for (const char* key : {"min", "max"})
    if (member(json, key).is_array() && member(json, key).size() != accessor.components)
      return asset.add(path_to(path, key), "has to have " + std::to_string(accessor.components) +
                                               " items, one for each component");
  // Read floats even without bounds: they have to be finite.
  if (!accessor.has_bounds && !is_float) return;
  const auto& range = asset.accessors.range(index);
  if (!range) return;
  if (!range->finite) return asset.add(path, "an element is not finite");
  for (const char* key : {"min", "max"}) {
    const Json& bounds = list(json, key);
    const auto& data = key[1] == 'i' ? range->min : range->max;
    for (size_t i = 0; i < bounds.size(); ++i)
      if (!is_bounded_by(bounds[i], data[i], is_float))
        return asset.add(path_to(path, key, i), bounds[i].dump().substr(0, 24) +
                                                    " is declared, but the data have " +
                                                    Json(data[i]).dump());
  }
}

void check_sparse(Asset& asset, size_t index, const std::string& path) {
  const Json& sparse = member(asset.list_of("accessors")[index], "sparse");
  const Json& views = asset.list_of("bufferViews");
  const Accessor& accessor = asset.accessors[index];
  const std::string here = path_to(path, "sparse");
  if (whole_number(sparse, "count").value_or(0) > accessor.count)
    asset.add(path_to(here, "count"),
              "is more than the accessor's " + std::to_string(accessor.count) + " elements");
  for (const char* part : {"indices", "values"}) {
    const auto view = index_below(member(sparse, part), "bufferView", views.size());
    const std::string at = path_to(path_to(here, part), "bufferView");
    if (!view) continue;
    if (has(views[*view], "byteStride")) asset.add(at, "names a view that has a byteStride");
    if (has(views[*view], "target")) asset.add(at, "names a view that has a target");
  }
}

void check_layout(Asset& asset, size_t index, const std::string& path) {
  const Accessor& accessor = asset.accessors[index];
  const bool is_integer = accessor.component != kFloat32 && accessor.component != kUint32;
  if (accessor.normalized && !is_integer)
    asset.add(path_to(path, "normalized"), "only 8 and 16-bit integers can be normalized");
  const uint32_t alignment = accessor.is_matrix() ? 4 : accessor.component_bytes;
  if (accessor.offset % alignment != 0)
    asset.add(
        path_to(path, "byteOffset"),
        std::to_string(accessor.offset) + " is not a multiple of " + std::to_string(alignment));
  if (!accessor.view) return;

  const Json& view = asset.list_of("bufferViews")[*accessor.view];
  const uint64_t view_offset = whole_number(view, "byteOffset").value_or(0);
  const uint64_t length = whole_number(view, "byteLength").value_or(0);
  const uint64_t declared_stride = whole_number(view, "byteStride").value_or(0);
  const uint64_t stride = declared_stride != 0 ? declared_stride : accessor.element_bytes;
  if (accessor.offset % alignment == 0 && view_offset % alignment != 0)
    asset.add(path, "starts at byte " + std::to_string(view_offset) +
                        " of its buffer and the accessor's offset: not a multiple of " +
                        std::to_string(alignment));
  if (stride < accessor.element_bytes)
    asset.add(path, "elements of " + std::to_string(accessor.element_bytes) +
                        " bytes overlap at a byteStride of " + std::to_string(stride));
  const bool fits =
      accessor.offset <= length && accessor.element_bytes <= length - accessor.offset &&
      accessor.count - 1 <= (length - accessor.offset - accessor.element_bytes) / stride;
  if (!fits && length > 0)
    asset.add(path, std::to_string(accessor.count) + " elements do not fit into the " +
                        std::to_string(length) + " bytes of " +
                        path_to("bufferViews", *accessor.view));
}

void check_data_uri(Asset& asset, const Json& buffer, const std::string& path) {
  const std::string_view uri = text(buffer, "uri");
  if (!is_data_uri(uri)) return;
  const auto type = media_type(uri);
  if (!type) return asset.add(path_to(path, "uri"), "is not a valid data URI");
  if (*type != "application/octet-stream" && *type != "application/gltf-buffer")
    asset.add(path_to(path, "uri"), "the media type " + in_quotes(*type) +
                                        " is not application/octet-stream or "
                                        "application/gltf-buffer");
}

}  // namespace

void check_buffers(Asset& asset) {
  const Json& buffers = asset.list_of("buffers");
  const Json& views = asset.list_of("bufferViews");
  for (size_t i = 0; i < buffers.size(); ++i) {
    const std::string path = path_to("buffers", i);
    check_data_uri(asset, buffers[i], path);
    const bool is_fallback = has(buffers[i], "extensions");
    if (!has(buffers[i], "uri") && !asset.file.has_data(i) && !is_fallback && i == 0 &&
        asset.file.is_binary())
      asset.add(path, "has no uri, and the GLB has no binary chunk");
  }
  for (size_t i = 0; i < views.size(); ++i) {
    const std::string path = path_to("bufferViews", i);
    const auto buffer = index_below(views[i], "buffer", buffers.size());
    const uint64_t offset = whole_number(views[i], "byteOffset").value_or(0);
    const uint64_t length = whole_number(views[i], "byteLength").value_or(0);
    const uint64_t stride = whole_number(views[i], "byteStride").value_or(0);
    const uint64_t size = buffer ? whole_number(buffers[*buffer], "byteLength").value_or(0) : 0;
    if (buffer && size > 0 && (offset > size || length > size - offset))
      asset.add(path, "is not within the " + std::to_string(size) + " bytes of " +
                          path_to("buffers", *buffer));
    if (stride > length && length > 0)
      asset.add(path_to(path, "byteStride"), "is more than the byteLength");
    if (stride > 0 && asset.view_uses[i] == ViewUse::indices)
      asset.add(path_to(path, "byteStride"), "only views of vertices may have one");
  }
}

void check_accessors(Asset& asset) {
  for (size_t i = 0; i < asset.accessors.size(); ++i) {
    if (!asset.accessors[i].known()) continue;
    const std::string path = path_to("accessors", i);
    check_layout(asset, i, path);
    if (has(asset.list_of("accessors")[i], "sparse")) check_sparse(asset, i, path);
    check_bounds(asset, i, path);
  }
}

}  // namespace lueur::conformance
