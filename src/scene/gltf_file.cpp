// SPDX-License-Identifier: MIT
#include "scene/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/file.h"
#include "base/try.h"
#include "scene/gltf_meshopt.h"
#include "scene/gltf_uri.h"
#include "scene/scene.h"

namespace lueur {
namespace {

constexpr uint32_t kGlbMagic = 0x46546C67;     // "glTF"
constexpr uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr uint32_t kBinaryChunk = 0x004E4942;  // "BIN\0"
constexpr size_t kGlbHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;

constexpr std::array kSupportedExtensions{std::string_view("KHR_lights_punctual"),
                                          std::string_view("KHR_materials_emissive_strength"),
                                          std::string_view("KHR_materials_specular"),
                                          std::string_view("KHR_mesh_quantization"),
                                          std::string_view("KHR_texture_transform"),
                                          std::string_view("KHR_materials_unlit"),
                                          std::string_view("EXT_mesh_gpu_instancing"),
                                          std::string_view("EXT_meshopt_compression"),
                                          std::string_view("KHR_materials_pbrSpecularGlossiness")};

struct Remedy {
  std::string_view extension;
  std::string_view advice;
};
constexpr std::array kRemedies{
    Remedy{"KHR_draco_mesh_compression",
           "re-export without Draco compression, or run 'gltf-transform copy in.glb out.glb'"},
    Remedy{"KHR_texture_basisu",
           "re-export with PNG or JPEG textures, or run 'gltf-transform ktxdecompress'"},
    Remedy{"EXT_texture_webp",
           "re-export with PNG or JPEG textures, or run 'gltf-transform png in.glb out.glb'"}};

uint32_t read_u32(std::span<const uint8_t> bytes, size_t offset) {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i) value |= uint32_t{bytes[offset + i]} << (8 * i);
  return value;
}

}  // namespace

bool is_supported(std::string_view extension) {
  return std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), extension) !=
         kSupportedExtensions.end();
}

std::string remedy_for(std::string_view extension) {
  for (const Remedy& remedy : kRemedies)
    if (remedy.extension == extension) return std::string(remedy.advice);
  return "re-export without it";
}

Result<GltfFile> GltfFile::open(const std::filesystem::path& path, const LoadLimits& limits) {
  GltfFile file;
  file.name_ = path.string();
  file.folder_ = path.parent_path();
  file.limits_ = limits;
  LUEUR_TRY(bytes, read_file(path, limits.file_bytes));
  file.bytes_ = std::move(bytes);
  return parse(std::move(file));
}

Result<GltfFile> GltfFile::from_bytes(std::vector<uint8_t> bytes, const std::string& name,
                                      const LoadLimits& limits) {
  GltfFile file;
  file.name_ = name;
  file.limits_ = limits;
  file.bytes_ = std::move(bytes);
  return parse(std::move(file));
}

Result<GltfFile> GltfFile::parse(GltfFile file) {
  const LoadLimits& limits = file.limits_;
  file.bytes_read_ = file.bytes_.size();

  // Tell the two containers apart by content; names lie.
  file.json_text_ = file.bytes_;
  if (file.bytes_.size() >= 4 && read_u32(file.bytes_, 0) == kGlbMagic)
    LUEUR_TRY_VOID(file.split_glb());

  const std::string_view text(reinterpret_cast<const char*>(file.json_text_.data()),
                              file.json_text_.size());
  if (text.starts_with("\xef\xbb\xbf"))
    file.add_container_fault("the JSON text starts with a byte order mark");
  LUEUR_TRY(json, parse_json(text, file.name_, limits.json_depth, limits.json_values));
  file.json_ = std::move(json);
  if (const auto key = find_duplicate_key(text))
    file.add_container_fault("JSON key " + in_quotes(*key) +
                             " comes twice in one object: the last one counts");
  LUEUR_TRY_VOID(file.check_header());
  LUEUR_TRY_VOID(file.read_buffers());
  LUEUR_TRY_VOID(file.decode_views());
  return file;
}

Result<void> GltfFile::split_glb() {
  const auto refuse = [this](const std::string& what) {
    return Error{ErrorKind::input, name_ + ": " + what + "; copy or export the file again"};
  };
  if (bytes_.size() < kGlbHeaderBytes) return refuse("GLB header is truncated");
  if (const uint32_t version = read_u32(bytes_, 4); version != 2)
    return refuse("GLB version " + std::to_string(version) + " is not 2");
  const uint64_t length = read_u32(bytes_, 8);
  if (length > bytes_.size())
    return refuse("GLB header tells " + std::to_string(length) + " bytes, the file has " +
                  std::to_string(bytes_.size()));

  if (length < bytes_.size())
    add_container_fault("GLB header tells " + std::to_string(length) + " bytes, the file has " +
                        std::to_string(bytes_.size()));

  // Walk the chunks: JSON comes first, then at most one binary chunk; unknown ones are skipped.
  const std::span<const uint8_t> all = std::span(bytes_).first(length);
  size_t offset = kGlbHeaderBytes;
  bool has_json = false;
  size_t chunk_count = 0;
  while (offset < all.size()) {
    if (all.size() - offset < kChunkHeaderBytes) return refuse("GLB chunk header is truncated");
    const uint64_t chunk_bytes = read_u32(all, offset);
    const uint32_t type = read_u32(all, offset + 4);
    offset += kChunkHeaderBytes;
    if (chunk_bytes > all.size() - offset)
      return refuse("GLB chunk tells " + std::to_string(chunk_bytes) + " bytes, " +
                    std::to_string(all.size() - offset) + " are left");
    const std::span<const uint8_t> chunk = all.subspan(offset, chunk_bytes);
    if (!has_json && type != kJsonChunk) return refuse("GLB does not start with a JSON chunk");
    ++chunk_count;
    if (chunk_bytes % 4 != 0)
      add_container_fault("a GLB chunk has " + std::to_string(chunk_bytes) +
                          " bytes, not a multiple of 4");
    if (type == kJsonChunk && !has_json) {
      json_text_ = chunk;
      has_json = true;
    } else if (type == kBinaryChunk && !binary_chunk_) {
      binary_chunk_ = chunk;
      if (chunk_count != 2) add_container_fault("the binary GLB chunk is not the second chunk");
    } else if (type == kJsonChunk || type == kBinaryChunk) {
      add_container_fault("a second GLB chunk of one kind is ignored");
    }
    // Step over the padding that a writer may have left out of the length.
    offset = std::min<size_t>((offset + chunk_bytes + 3) & ~size_t{3}, all.size());
  }
  if (!has_json) return refuse("GLB has no JSON chunk");
  return {};
}

Result<void> GltfFile::check_header() const {
  const JsonCursor top = root();
  LUEUR_TRY(asset, top.object("asset"));
  LUEUR_TRY(version, asset.text("version", ""));
  if (!version.starts_with("2."))
    return asset.error("version", version.empty() ? "is missing; this is not a glTF 2.0 file"
                                                  : in_quotes(version) +
                                                        " is not 2.x; convert the "
                                                        "file to glTF 2.0");
  LUEUR_TRY(min_version, asset.text("minVersion", "2.0"));
  if (min_version != "2.0")
    return asset.error("minVersion", in_quotes(min_version) + " is newer than 2.0");

  LUEUR_TRY(required, top.texts("extensionsRequired"));
  for (const std::string& extension : required) {
    if (is_supported(extension)) continue;
    return top.error("extensionsRequired",
                     printable(extension) + " is not supported; " + remedy_for(extension));
  }
  return {};
}

Result<void> GltfFile::read_buffers() {
  const JsonCursor top = root();
  LUEUR_TRY(buffers, top.array("buffers"));
  buffers_.resize(buffers.size());
  for (size_t i = 0; i < buffers.size(); ++i) {
    LUEUR_TRY(buffer, buffers.element(i));
    LUEUR_TRY(length, buffer.required_count("byteLength", limits_.file_bytes));
    std::span<const uint8_t> bytes;
    if (buffer.has("uri")) {
      LUEUR_TRY(uri, buffer.text("uri", ""));
      LUEUR_TRY(storage, read_uri(uri, buffer));
      buffers_[i].storage = std::move(storage);
      bytes = buffers_[i].storage;
    } else if (i == 0 && binary_chunk_) {
      bytes = *binary_chunk_;
    } else {
      continue;  // refused only if something reads from it
    }
    if (length > bytes.size())
      return buffer.error("byteLength", std::to_string(length) + " is more than the " +
                                            std::to_string(bytes.size()) +
                                            " bytes there are; the file is truncated");
    buffers_[i].bytes = bytes.first(length);
  }
  return {};
}

size_t GltfFile::size_of(const char* key) const {
  const auto found = json_.find(key);
  return found != json_.end() && found->is_array() ? found->size() : 0;
}

Result<GltfFile::View> GltfFile::view(int32_t view) const {
  constexpr uint64_t kMaxStride = 252;
  const JsonCursor top = root();
  LUEUR_TRY(views, top.array("bufferViews"));
  LUEUR_TRY(at, views.element(static_cast<size_t>(view)));
  LUEUR_TRY(stride, at.count("byteStride", 0, kMaxStride));
  if (const auto& decoded = decoded_views_[static_cast<size_t>(view)])
    return View{*decoded, static_cast<uint32_t>(stride)};
  LUEUR_TRY(buffer, at.required_index("buffer", buffers_.size(), "buffers"));
  LUEUR_TRY(offset, at.count("byteOffset", 0, limits_.file_bytes));
  LUEUR_TRY(length, at.required_count("byteLength", limits_.file_bytes));
  LUEUR_TRY(bytes, bytes_of(at, buffer, offset, length));
  return View{bytes, static_cast<uint32_t>(stride)};
}

Result<std::span<const uint8_t>> GltfFile::bytes_of(const JsonCursor& at, int32_t buffer,
                                                    uint64_t offset, uint64_t length) const {
  const std::optional<std::span<const uint8_t>>& bytes =
      buffers_[static_cast<size_t>(buffer)].bytes;
  if (!bytes)
    return at.error("buffer", "buffer " + std::to_string(buffer) +
                                  " has neither a uri nor a GLB chunk; re-export the file");
  if (offset > bytes->size() || length > bytes->size() - offset)
    return at.error("bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) +
                    " are not all within the buffer's " + std::to_string(bytes->size()) +
                    "; re-export the file");
  return bytes->subspan(offset, length);
}

// Unpacks the views that are stored compressed, at once: textures and accessors share them.
Result<void> GltfFile::decode_views() {
  constexpr const char* kExtension = "EXT_meshopt_compression";
  decoded_views_.resize(size_of("bufferViews"));
  const JsonCursor top = root();
  LUEUR_TRY(views, top.array("bufferViews"));
  for (size_t i = 0; i < views.size(); ++i) {
    LUEUR_TRY(at, views.element(i));
    if (!at.has("extensions")) continue;
    LUEUR_TRY(extensions, at.object("extensions"));
    if (!extensions.has(kExtension)) continue;
    LUEUR_TRY(extension, extensions.object(kExtension));
    const uint64_t left = limits_.file_bytes - std::min(bytes_read_, limits_.file_bytes);
    LUEUR_TRY(view, read_meshopt_view(extension, buffers_.size(), left));
    LUEUR_TRY(compressed, bytes_of(extension, view.buffer, view.byte_offset, view.byte_length));
    LUEUR_TRY(decoded, decode_meshopt(extension, view, compressed));
    bytes_read_ += decoded.size();
    decoded_views_[i] = std::move(decoded);
  }
  return {};
}

void GltfFile::add_container_fault(std::string what) {
  constexpr size_t kMaxFaults = 8;  // a file may have millions of chunks
  if (container_faults_.size() < kMaxFaults) container_faults_.push_back(std::move(what));
}

bool GltfFile::view_has_data(int32_t view) const {
  if (decoded_views_[static_cast<size_t>(view)]) return true;
  const JsonCursor top = root();
  const auto views = top.array("bufferViews");
  if (!views.ok()) return true;
  const auto at = views->element(static_cast<size_t>(view));
  if (!at.ok()) return true;
  const auto buffer = at->index("buffer", buffers_.size(), "buffers");
  return !buffer.ok() || *buffer == kNone || has_data(static_cast<size_t>(*buffer));
}

uint64_t GltfFile::buffer_bytes() const {
  uint64_t sum = 0;
  for (const Buffer& buffer : buffers_) sum += buffer.bytes ? buffer.bytes->size() : 0;
  return sum;
}

Result<std::vector<uint8_t>> GltfFile::head_of_uri(const std::string& uri, size_t max_bytes) const {
  if (is_data_uri(uri)) return decode_data_uri(uri);
  if (!folder_) return Error{ErrorKind::input, "names another file"};
  LUEUR_TRY(path, confined_path(*folder_, uri));
  return read_file_head(path, max_bytes);
}

Result<std::vector<uint8_t>> GltfFile::read_uri(const std::string& uri, const JsonCursor& at) {
  if (is_data_uri(uri)) {
    auto data = decode_data_uri(uri);
    if (!data.ok()) return at.error("uri", data.error().message);
    return data;
  }
  if (!folder_)
    return at.error("uri",
                    "names another file, but this one was read from memory; pack all into one");
  const auto path = confined_path(*folder_, uri);
  if (!path.ok()) return at.error("uri", path.error().message);
  auto bytes = read_file(*path, limits_.file_bytes - std::min(bytes_read_, limits_.file_bytes));
  if (!bytes.ok()) return at.error("uri", bytes.error().message);
  bytes_read_ += bytes->size();
  return bytes;
}

}  // namespace lueur
