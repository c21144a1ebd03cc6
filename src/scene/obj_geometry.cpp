// SPDX-License-Identifier: MIT
#include "scene/obj_geometry.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/try.h"
#include "scene/gltf_json.h"

namespace lueur {
namespace {

// Names in the order in which they first came.
class NameTable {
 public:
  explicit NameTable(std::vector<std::string>& names) : names_(&names) {}
  uint32_t place_of(const std::string& name) {
    const auto [entry, is_new] = places_.try_emplace(name, static_cast<uint32_t>(names_->size()));
    if (is_new) names_->push_back(name);
    return entry->second;
  }

 private:
  std::vector<std::string>* names_;
  std::map<std::string, uint32_t, std::less<>> places_;
};

class GeometryReader {
 public:
  GeometryReader(std::string_view text, const std::string& file, const LoadLimits& limits,
                 Warnings& warnings)
      // A face is its keyword and its corners.
      : lines_(text, file, size_t{std::max(limits.polygon_corners, 64u)} + 1),
        limits_(&limits),
        warnings_(&warnings) {}

  Result<ObjGeometry> read();

 private:
  Result<void> read_line();
  Result<void> read_position();
  Result<void> read_uv();
  Result<void> read_normal();
  Result<void> read_face();
  Result<ObjCorner> read_corner(std::string_view word) const;
  Result<int32_t> read_index(std::string_view word, size_t size, const char* things) const;
  Result<void> read_smoothing();
  void warn_of(std::string_view keyword);
  void name_mesh();
  Result<void> check_count(uint64_t count, uint64_t limit, const char* things) const;

  ObjLines lines_;
  const LoadLimits* limits_;
  Warnings* warnings_;
  ObjGeometry geometry_;
  NameTable meshes_{geometry_.mesh_names};
  NameTable materials_{geometry_.material_names};
  std::string object_, group_;
  ObjFace state_;  // what holds for the faces to come
  bool has_mesh_ = false, has_material_ = false;
};

Result<ObjGeometry> GeometryReader::read() {
  for (;;) {
    LUEUR_TRY(more, lines_.next());
    if (!more) return std::move(geometry_);
    LUEUR_TRY_VOID(read_line());
  }
}

Result<void> GeometryReader::read_line() {
  const std::string_view keyword = lines_.words()[0];
  if (keyword == "v") return read_position();
  if (keyword == "vt") return read_uv();
  if (keyword == "vn") return read_normal();
  if (keyword == "f" || keyword == "fo") return read_face();
  if (keyword == "s") return read_smoothing();
  const std::string name(lines_.rest_from(1));
  if (keyword == "o") {
    object_ = name;
    group_.clear();
    has_mesh_ = false;
  } else if (keyword == "g") {
    group_ = name;
    has_mesh_ = false;
  } else if (keyword == "usemtl") {
    state_.material = materials_.place_of(name);
    has_material_ = true;
  } else if (keyword == "mtllib") {
    if (std::ranges::find(geometry_.libraries, name) == geometry_.libraries.end())
      geometry_.libraries.push_back(name);
    return check_count(geometry_.libraries.size(), limits_->images, "MTL files");
  } else {
    warn_of(keyword);
  }
  return {};
}

Result<void> GeometryReader::check_count(uint64_t count, uint64_t limit, const char* things) const {
  // Indices of both signs have to fit into 31 bits, whatever the limits say.
  if (count <= std::min<uint64_t>(limit, INT32_MAX)) return {};
  return lines_.error("more than " + std::to_string(limit) + " " + things +
                      "; split the file, or raise the limit");
}

Result<void> GeometryReader::read_position() {
  std::array<float, 7> v{};
  LUEUR_TRY(count, lines_.numbers(v, 3));
  if (count >= 6) warnings_->add("colours of vertices are left out");
  LUEUR_TRY_VOID(check_count(geometry_.positions.size() + 1, limits_->vertices, "positions"));
  geometry_.positions.emplace_back(v[0], v[1], v[2]);
  return {};
}

Result<void> GeometryReader::read_uv() {
  std::array<float, 2> v{};
  LUEUR_TRY_VOID(lines_.numbers(v, 1));
  LUEUR_TRY_VOID(check_count(geometry_.uvs.size() + 1, limits_->vertices, "texture coordinates"));
  geometry_.uvs.emplace_back(v[0], v[1]);
  return {};
}

Result<void> GeometryReader::read_normal() {
  std::array<float, 3> v{};
  LUEUR_TRY_VOID(lines_.numbers(v, 3));
  LUEUR_TRY_VOID(check_count(geometry_.normals.size() + 1, limits_->vertices, "normals"));
  geometry_.normals.emplace_back(v[0], v[1], v[2]);
  return {};
}

// From 1 on; negative ones count back from the last that came before.
Result<int32_t> GeometryReader::read_index(std::string_view word, size_t size,
                                           const char* things) const {
  const std::optional<int64_t> index = integer_of(word);
  if (!index) return lines_.error(in_quotes(word) + " is not an index; export the file again");
  const int64_t count = static_cast<int64_t>(size);
  if (*index == 0 || *index > count || *index < -count)
    return lines_.error("index " + std::to_string(*index) + " points at none of the " +
                        std::to_string(count) + " " + things + " before it; export the file again");
  return static_cast<int32_t>(*index > 0 ? *index - 1 : count + *index);
}

// "position", "position/uv", "position//normal" or "position/uv/normal".
Result<ObjCorner> GeometryReader::read_corner(std::string_view word) const {
  std::array<std::string_view, 3> parts;
  std::string_view rest = word;
  for (std::string_view& part : parts) {
    const size_t slash = rest.find('/');
    part = rest.substr(0, slash);
    rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
  }
  if (!rest.empty())
    return lines_.error(in_quotes(word) + " has more than three indices; export the file again");
  ObjCorner corner;
  LUEUR_TRY(position, read_index(parts[0], geometry_.positions.size(), "positions"));
  corner.position = position;
  if (!parts[1].empty()) {
    LUEUR_TRY(uv, read_index(parts[1], geometry_.uvs.size(), "texture coordinates"));
    corner.uv = uv;
  }
  if (!parts[2].empty()) {
    LUEUR_TRY(normal, read_index(parts[2], geometry_.normals.size(), "normals"));
    corner.normal = normal;
  }
  return corner;
}

Result<void> GeometryReader::read_face() {
  const auto words = lines_.words().subspan(1);
  if (words.size() < 3) {
    warnings_->add("polygons of less than three corners are not drawn");
    return {};
  }
  if (words.size() > limits_->polygon_corners)
    return lines_.error("a polygon of more than " + std::to_string(limits_->polygon_corners) +
                        " corners; split it, or raise the limit");
  LUEUR_TRY_VOID(check_count(geometry_.corners.size() + words.size(), limits_->indices,
                             "corners of polygons"));
  if (!has_mesh_) name_mesh();
  LUEUR_TRY_VOID(check_count(geometry_.mesh_names.size(), limits_->nodes, "objects and groups"));
  if (!has_material_) state_.material = materials_.place_of("");
  has_material_ = true;
  ObjFace face = state_;
  face.first_corner = static_cast<uint32_t>(geometry_.corners.size());
  face.corner_count = static_cast<uint32_t>(words.size());
  for (const std::string_view word : words) {
    LUEUR_TRY(corner, read_corner(word));
    geometry_.corners.push_back(corner);
  }
  geometry_.faces.push_back(face);
  return {};
}

void GeometryReader::name_mesh() {
  const bool both = !object_.empty() && !group_.empty();
  state_.mesh = meshes_.place_of(both ? object_ + "/" + group_ : object_ + group_);
  has_mesh_ = true;
}

Result<void> GeometryReader::read_smoothing() {
  const std::string_view group = lines_.words().size() > 1 ? lines_.words()[1] : "off";
  if (group == "off" || group == "on") {
    state_.smoothing = group == "on" ? 1 : 0;
    return {};
  }
  const std::optional<int64_t> number = integer_of(group);
  if (!number || *number < 0 || *number > UINT32_MAX)
    return lines_.error(in_quotes(group) + " is not a smoothing group; write a number or 'off'");
  state_.smoothing = static_cast<uint32_t>(*number);
  return {};
}

void GeometryReader::warn_of(std::string_view keyword) {
  constexpr std::array<std::string_view, 13> kCurves = {"vp",   "cstype", "deg",  "bmat", "step",
                                                        "curv", "curv2",  "surf", "parm", "trim",
                                                        "hole", "con",    "end"};
  constexpr std::array<std::string_view, 11> kSkipped = {
      "mg",     "bevel",      "c_interp",  "d_interp", "lod",  "maplib",
      "usemap", "shadow_obj", "trace_obj", "ctech",    "stech"};
  if (keyword == "p" || keyword == "l")
    warnings_->add("points and lines are not drawn");
  else if (std::ranges::find(kCurves, keyword) != kCurves.end())
    warnings_->add("curves and free-form surfaces are not drawn");
  else if (std::ranges::find(kSkipped, keyword) == kSkipped.end())
    warnings_->add("statements " + in_quotes(keyword) + " are not understood and passed over");
}

}  // namespace

Result<ObjGeometry> read_obj_geometry(std::string_view text, const std::string& file,
                                      const LoadLimits& limits, Warnings& warnings) {
  return GeometryReader(text, file, limits, warnings).read();
}

}  // namespace lueur
