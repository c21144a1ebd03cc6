// SPDX-License-Identifier: MIT
#include "scene/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/try.h"
#include "scene/gltf_accessor.h"
#include "scene/vertex_frame.h"

namespace lueur {
namespace {

enum Attribute : size_t { kPosition, kNormal, kTangent, kUv, kAttributeCount };

// One primitive's accessors; kNone where it has none. Primitives with the same ones share vertices.
using Accessors = std::array<int32_t, kAttributeCount>;

constexpr uint64_t kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6;

// Turns a strip or a fan into separate triangles, keeping their winding.
std::vector<uint32_t> separate_triangles(std::vector<uint32_t> corners, uint64_t mode) {
  if (mode == kTriangles) {
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  std::vector<uint32_t> triangles;
  if (corners.size() >= 3) triangles.reserve((corners.size() - 2) * 3);
  for (size_t i = 0; i + 2 < corners.size(); ++i) {
    const bool flipped = mode == kTriangleStrip && i % 2 == 1;
    triangles.push_back(mode == kTriangleFan ? corners[0] : corners[flipped ? i + 1 : i]);
    triangles.push_back(mode == kTriangleFan ? corners[i + 1] : corners[flipped ? i : i + 1]);
    triangles.push_back(corners[i + 2]);
  }
  return triangles;
}

// Splits the triangles apart, so that each vertex can have its face's normal.
std::vector<Vertex> split_flat(const std::vector<Vertex>& vertices,
                               std::vector<uint32_t>& corners) {
  std::vector<Vertex> split;
  split.reserve(corners.size());
  for (const uint32_t corner : corners) split.push_back(vertices[corner]);
  std::iota(corners.begin(), corners.end(), 0u);
  make_flat_normals(split);
  return split;
}

std::string uv_key_of(uint32_t uv_set) {
  return "TEXCOORD_" + std::to_string(uv_set);
}

class MeshReader {
 public:
  MeshReader(const GltfFile& file, GltfMaterials& materials, GeometryBudget& budget,
             Warnings& warnings)
      : file_(&file), materials_(&materials), budget_(&budget), warnings_(&warnings) {}

  Result<Mesh> read(const JsonCursor& at);

 private:
  Result<void> read_primitive(const JsonCursor& at);
  Result<Accessors> read_accessors(const JsonCursor& attributes, uint32_t uv_set) const;
  Result<std::vector<uint32_t>> read_corners(const JsonCursor& at, uint64_t mode,
                                             uint64_t vertex_count);
  Result<std::vector<Vertex>> read_vertices(const JsonCursor& attributes,
                                            const Accessors& accessors, uint32_t uv_set,
                                            uint64_t count) const;
  Result<std::vector<float>> read_attribute(const JsonCursor& attributes, const char* key,
                                            int32_t accessor, uint32_t components,
                                            uint64_t count) const;
  void warn_of_what_is_left_out(const JsonCursor& at, const JsonCursor& attributes);
  Result<void> spend(const JsonCursor& at, uint64_t& left, uint64_t count,
                     const char* things) const;
  Error over_budget(const JsonCursor& at, const char* things) const;

  const GltfFile* file_;
  GltfMaterials* materials_;
  GeometryBudget* budget_;
  Warnings* warnings_;
  Mesh mesh_;
  std::map<Accessors, uint32_t> first_vertices_;
};

Result<Mesh> MeshReader::read(const JsonCursor& at) {
  LUEUR_TRY(name, at.text("name", ""));
  mesh_.name = name;
  LUEUR_TRY(primitives, at.array("primitives"));
  for (size_t i = 0; i < primitives.size(); ++i) {
    LUEUR_TRY(primitive, primitives.element(i));
    LUEUR_TRY_VOID(read_primitive(primitive));
  }
  // Repair at the end: several primitives may share vertices.
  if (repair_normals(mesh_.vertices, mesh_.indices) > 0)
    warnings_->add("normals of length 0 are replaced by the mean of their faces' normals");
  make_tangents(mesh_.vertices, mesh_.indices);
  return std::move(mesh_);
}

Result<void> MeshReader::read_primitive(const JsonCursor& at) {
  LUEUR_TRY(mode, at.count("mode", kTriangles, kTriangleFan));
  if (mode < kTriangles) {
    warnings_->add("points and lines are not drawn");
    return {};
  }
  LUEUR_TRY(attributes, at.object("attributes"));
  warn_of_what_is_left_out(at, attributes);
  LUEUR_TRY(material_index, at.index("material", file_->size_of("materials"), "materials"));
  LUEUR_TRY(material, materials_->use(material_index));
  LUEUR_TRY(accessors, read_accessors(attributes, material.uv_set));
  if (accessors[kPosition] == kNone) {
    warnings_->add("primitives without positions are not drawn");
    return {};
  }
  LUEUR_TRY(shape, accessor_shape(*file_, accessors[kPosition]));
  if (!shape.has_data) {
    LUEUR_TRY(extensions, at.object("extensions"));
    if (extensions.has("KHR_draco_mesh_compression"))
      return at.error("the positions are stored with Draco compression only; " +
                      remedy_for("KHR_draco_mesh_compression"));
    warnings_->add("primitives without positions are not drawn");
    return {};
  }
  LUEUR_TRY(corners, read_corners(at, mode, shape.count));
  if (corners.empty()) return {};

  // Take over the vertices, unless an earlier primitive already did.
  LUEUR_TRY_VOID(spend(at, budget_->indices, corners.size(), "indices"));
  const auto known = first_vertices_.find(accessors);
  uint32_t first_vertex = static_cast<uint32_t>(mesh_.vertices.size());
  if (known != first_vertices_.end()) {
    first_vertex = known->second;
  } else {
    LUEUR_TRY_VOID(spend(at, budget_->vertices, shape.count, "vertices"));
    LUEUR_TRY(vertices, read_vertices(attributes, accessors, material.uv_set, shape.count));
    if (accessors[kNormal] == kNone) {
      LUEUR_TRY_VOID(spend(at, budget_->vertices, corners.size(), "vertices"));
      vertices = split_flat(vertices, corners);
    } else {
      first_vertices_[accessors] = first_vertex;
    }
    mesh_.vertices.insert(mesh_.vertices.end(), vertices.begin(), vertices.end());
  }
  const uint32_t first_index = static_cast<uint32_t>(mesh_.indices.size());
  for (const uint32_t corner : corners) mesh_.indices.push_back(first_vertex + corner);
  mesh_.primitives.push_back(
      {first_index, static_cast<uint32_t>(corners.size()), material.material});
  return {};
}

Result<Accessors> MeshReader::read_accessors(const JsonCursor& attributes, uint32_t uv_set) const {
  const size_t accessor_count = file_->size_of("accessors");
  const std::string uv_key = uv_key_of(uv_set);
  const std::array<const char*, kAttributeCount> keys{"POSITION", "NORMAL", "TANGENT",
                                                      uv_key.c_str()};
  Accessors accessors{};
  for (size_t i = 0; i < keys.size(); ++i) {
    LUEUR_TRY(accessor, attributes.index(keys[i], accessor_count, "accessors"));
    accessors[i] = accessor;
  }
  // Tangents without the normals they belong to say nothing.
  if (accessors[kNormal] == kNone) accessors[kTangent] = kNone;
  return accessors;
}

Result<std::vector<uint32_t>> MeshReader::read_corners(const JsonCursor& at, uint64_t mode,
                                                       uint64_t vertex_count) {
  LUEUR_TRY(accessor, at.index("indices", file_->size_of("accessors"), "accessors"));
  uint64_t corner_count = vertex_count;
  if (accessor != kNone) {
    LUEUR_TRY(shape, accessor_shape(*file_, accessor));
    corner_count = shape.count;
  }
  const uint64_t triangle_corners = mode == kTriangles ? corner_count : corner_count * 3;
  if (triangle_corners > budget_->indices) return over_budget(at, "indices");
  if (mode == kTriangles && corner_count % 3 != 0)
    warnings_->add("a triangle list that is not a multiple of 3 is cut short");

  std::vector<uint32_t> corners;
  if (accessor == kNone) {
    if (vertex_count > budget_->vertices) return over_budget(at, "vertices");
    corners.resize(vertex_count);
    std::iota(corners.begin(), corners.end(), 0u);
  } else {
    LUEUR_TRY(indices, read_unsigned(*file_, accessor));
    const auto largest = std::max_element(indices.begin(), indices.end());
    if (*largest >= vertex_count)
      return at.error("indices", std::to_string(*largest) + " is not below the " +
                                     std::to_string(vertex_count) +
                                     " vertices; re-export the file");
    corners = std::move(indices);
  }
  return separate_triangles(std::move(corners), mode);
}

Result<std::vector<float>> MeshReader::read_attribute(const JsonCursor& attributes, const char* key,
                                                      int32_t accessor, uint32_t components,
                                                      uint64_t count) const {
  if (accessor == kNone) return std::vector<float>();
  LUEUR_TRY(shape, accessor_shape(*file_, accessor));
  if (shape.components != components)
    return attributes.error(key, "has to be a VEC" + std::to_string(components));
  if (shape.count != count)
    return attributes.error(key, std::to_string(shape.count) + " elements for " +
                                     std::to_string(count) + " positions; re-export the file");
  LUEUR_TRY(values, read_floats(*file_, accessor));
  for (size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      return attributes.error(key, "vertex " + std::to_string(i / components) + " of mesh '" +
                                       printable(mesh_.name) +
                                       "' is not finite; repair and re-export the model");
  return std::move(values);
}

Result<std::vector<Vertex>> MeshReader::read_vertices(const JsonCursor& attributes,
                                                      const Accessors& accessors, uint32_t uv_set,
                                                      uint64_t count) const {
  const std::string uv_key = uv_key_of(uv_set);
  LUEUR_TRY(positions, read_attribute(attributes, "POSITION", accessors[kPosition], 3, count));
  LUEUR_TRY(normals, read_attribute(attributes, "NORMAL", accessors[kNormal], 3, count));
  LUEUR_TRY(tangents, read_attribute(attributes, "TANGENT", accessors[kTangent], 4, count));
  LUEUR_TRY(uvs, read_attribute(attributes, uv_key.c_str(), accessors[kUv], 2, count));

  std::vector<Vertex> vertices(count);
  for (size_t i = 0; i < vertices.size(); ++i) {
    Vertex& vertex = vertices[i];
    vertex.position = {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
    vertex.normal = normals.empty()
                        ? glm::vec3(0.0f)
                        : glm::vec3(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
    vertex.tangent = tangents.empty() ? glm::vec4(0.0f)
                                      : glm::vec4(tangents[4 * i], tangents[4 * i + 1],
                                                  tangents[4 * i + 2], tangents[4 * i + 3]);
    vertex.uv = uvs.empty() ? glm::vec2(0.0f) : glm::vec2(uvs[2 * i], uvs[2 * i + 1]);
  }
  return vertices;
}

void MeshReader::warn_of_what_is_left_out(const JsonCursor& at, const JsonCursor& attributes) {
  if (at.has("targets")) warnings_->add("morph targets are not supported: drawn undeformed");
  if (attributes.has("COLOR_0")) warnings_->add("vertex colours are not supported: drawn without");
}

Result<void> MeshReader::spend(const JsonCursor& at, uint64_t& left, uint64_t count,
                               const char* things) const {
  if (count > left) return over_budget(at, things);
  left -= count;
  return {};
}

Error MeshReader::over_budget(const JsonCursor& at, const char* things) const {
  const bool of_vertices = std::string_view(things) == "vertices";
  const uint64_t limit = of_vertices ? file_->limits().vertices : file_->limits().indices;
  return at.error("the meshes have more than " + std::to_string(limit) + " " + things +
                  "; simplify the model");
}

}  // namespace

Result<Mesh> read_mesh(const GltfFile& file, int32_t index, GltfMaterials& materials,
                       GeometryBudget& budget, Warnings& warnings) {
  const JsonCursor top = file.root();
  LUEUR_TRY(meshes, top.array("meshes"));
  LUEUR_TRY(at, meshes.element(static_cast<size_t>(index)));
  return MeshReader(file, materials, budget, warnings).read(at);
}

}  // namespace lueur
