// SPDX-License-Identifier: MIT
#include "scene/gltf_meshopt.h"

#include <meshoptimizer.h>

#include <string>

#include "base/try.h"

namespace lueur {
namespace {

using Mode = MeshoptView::Mode;
using Filter = MeshoptView::Filter;

Result<Mode> read_mode(const JsonCursor& at) {
  LUEUR_TRY(name, at.text("mode", ""));
  if (name == "ATTRIBUTES") return Mode::attributes;
  if (name == "TRIANGLES") return Mode::triangles;
  if (name == "INDICES") return Mode::indices;
  return at.error("mode", in_quotes(name) + " is not ATTRIBUTES, TRIANGLES or INDICES");
}

Result<Filter> read_filter(const JsonCursor& at) {
  LUEUR_TRY(name, at.text("filter", "NONE"));
  if (name == "NONE") return Filter::none;
  if (name == "OCTAHEDRAL") return Filter::octahedral;
  if (name == "QUATERNION") return Filter::quaternion;
  if (name == "EXPONENTIAL") return Filter::exponential;
  return at.error("filter",
                  in_quotes(name) + " is not NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL");
}

// The strides that the decoder promises to bear: it checks none itself.
bool fits(const MeshoptView& view) {
  const uint64_t stride = view.stride;
  if (view.mode != Mode::attributes)
    return (stride == 2 || stride == 4) && view.filter == Filter::none &&
           (view.mode == Mode::indices || view.count % 3 == 0);
  if (stride == 0 || stride > 256 || stride % 4 != 0) return false;
  if (view.filter == Filter::octahedral) return stride == 4 || stride == 8;
  if (view.filter == Filter::quaternion) return stride == 8;
  return true;
}

}  // namespace

Result<MeshoptView> read_meshopt_view(const JsonCursor& at, size_t buffer_count,
                                      uint64_t most_bytes) {
  constexpr uint64_t kMaxStride = 256;
  MeshoptView view;
  LUEUR_TRY(mode, read_mode(at));
  LUEUR_TRY(filter, read_filter(at));
  LUEUR_TRY(buffer, at.required_index("buffer", buffer_count, "buffers"));
  LUEUR_TRY(offset, at.count("byteOffset", 0, most_bytes));
  LUEUR_TRY(length, at.required_count("byteLength", most_bytes));
  LUEUR_TRY(stride, at.required_count("byteStride", kMaxStride));
  LUEUR_TRY(count, at.required_count("count", most_bytes));
  view.mode = mode;
  view.filter = filter;
  view.buffer = buffer;
  view.byte_offset = offset;
  view.byte_length = length;
  view.stride = stride;
  view.count = count;
  if (!fits(view))
    return at.error("byteStride", std::to_string(stride) + " with " + std::to_string(count) +
                                      " elements does not fit its mode and filter");
  if (view.decoded_bytes() > most_bytes)
    return at.error("count", "decoded, the buffers take more than the limit of " +
                                 std::to_string(most_bytes) + " bytes");
  return view;
}

Result<std::vector<uint8_t>> decode_meshopt(const JsonCursor& at, const MeshoptView& view,
                                            std::span<const uint8_t> compressed) {
  std::vector<uint8_t> bytes(view.decoded_bytes());
  if (bytes.empty()) return bytes;
  const auto decode = [&] {
    switch (view.mode) {
      case Mode::attributes:
        return meshopt_decodeVertexBuffer(bytes.data(), view.count, view.stride, compressed.data(),
                                          compressed.size());
      case Mode::triangles:
        return meshopt_decodeIndexBuffer(bytes.data(), view.count, view.stride, compressed.data(),
                                         compressed.size());
      case Mode::indices:
        return meshopt_decodeIndexSequence(bytes.data(), view.count, view.stride, compressed.data(),
                                           compressed.size());
    }
    return -1;
  };
  if (decode() != 0) return at.error("the compressed data are damaged; re-export the file");
  switch (view.filter) {
    case Filter::none:
      break;
    case Filter::octahedral:
      meshopt_decodeFilterOct(bytes.data(), view.count, view.stride);
      break;
    case Filter::quaternion:
      meshopt_decodeFilterQuat(bytes.data(), view.count, view.stride);
      break;
    case Filter::exponential:
      meshopt_decodeFilterExp(bytes.data(), view.count, view.stride);
      break;
  }
  return bytes;
}

}  // namespace lueur
