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
#include "scene/gltf_vertices.h"
#include "scene/vertex_frame.h"

namespace lueur {
namespace {

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

class MeshReader {
 public:
  MeshReader(const GltfFile& file, GltfMaterials& materials, GeometryBudget& budget,
             Warnings& warnings)
      : file_(&file), materials_(&materials), budget_(&budget), warnings_(&warnings) {}

  Result<Mesh> read(const JsonCursor& at);

 private:
  Result<void> read_primitive(const JsonCursor& at);
  Result<std::vector<uint32_t>> read_corners(const JsonCursor& at, uint64_t mode,
                                             uint64_t vertex_count);
  void append(PrimitiveVertices primitive);
  Result<void> spend(const JsonCursor& at, uint64_t& left, uint64_t count,
                     const char* things) const;
  Error over_budget(const JsonCursor& at, const char* things) const;

  const GltfFile* file_;
  GltfMaterials* materials_;
  GeometryBudget* budget_;
  Warnings* warnings_;
  Mesh mesh_;
  std::map<VertexAccessors, uint32_t> first_vertices_;
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
  LUEUR_TRY(material_index, at.index("material", file_->size_of("materials"), "materials"));
  LUEUR_TRY(material, materials_->use(material_index));
  LUEUR_TRY(accessors, find_vertices(*file_, at, material.uv_sets, *warnings_));
  if (accessors.position == kNone) {
    warnings_->add("primitives without positions are not drawn");
    return {};
  }
  LUEUR_TRY(shape, accessor_shape(*file_, accessors.position));
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
    const bool is_flat = accessors.normal == kNone;
    const uint64_t copies = 1 + accessors.targets.size();
    LUEUR_TRY_VOID(spend(at, budget_->vertices, shape.count * copies, "vertices"));
    if (is_flat) LUEUR_TRY_VOID(spend(at, budget_->vertices, corners.size() * copies, "vertices"));
    LUEUR_TRY(vertices, read_vertices(*file_, at, accessors, shape.count, mesh_.name, *warnings_));
    if (is_flat)
      split_flat(vertices, corners);
    else
      first_vertices_[accessors] = first_vertex;
    append(std::move(vertices));
  }
  const uint32_t first_index = static_cast<uint32_t>(mesh_.indices.size());
  for (const uint32_t corner : corners) mesh_.indices.push_back(first_vertex + corner);
  mesh_.primitives.push_back(
      {first_index, static_cast<uint32_t>(corners.size()), material.material});
  return {};
}

// Appends `more` to `all`, of which there are `size` entries or none.
template <class T>
void append_padded(std::vector<T>& all, size_t size, std::vector<T> more, size_t more_size,
                   const T& padding) {
  if (more.empty() && all.empty()) return;
  all.resize(size, padding);
  more.resize(more_size, padding);
  all.insert(all.end(), more.begin(), more.end());
}

// Adds a primitive's vertices to the mesh'. Where only some primitives have joints or a morph
// target, the others follow the first joint and stay.
void MeshReader::append(PrimitiveVertices primitive) {
  const size_t size = mesh_.vertices.size(), more = primitive.vertices.size();
  append_padded(mesh_.influences, size, std::move(primitive.influences), more,
                {glm::u16vec4(uint16_t{0}), glm::vec4(1.0f, 0.0f, 0.0f, 0.0f)});
  const size_t target_count = std::max(mesh_.morph_targets.size(), primitive.targets.size());
  if (size > 0 && primitive.targets.size() != mesh_.morph_targets.size())
    warnings_->add("the primitives of a mesh differ in their number of morph targets");
  mesh_.morph_targets.resize(target_count);
  primitive.targets.resize(target_count);
  for (size_t t = 0; t < target_count; ++t) {
    MorphTarget &all = mesh_.morph_targets[t], &new_ones = primitive.targets[t];
    const glm::vec3 none(0.0f);
    append_padded(all.positions, size, std::move(new_ones.positions), more, none);
    append_padded(all.normals, size, std::move(new_ones.normals), more, none);
    append_padded(all.tangents, size, std::move(new_ones.tangents), more, none);
  }
  if (mesh_.vertices.empty())
    mesh_.vertices = std::move(primitive.vertices);
  else
    mesh_.vertices.insert(mesh_.vertices.end(), primitive.vertices.begin(),
                          primitive.vertices.end());
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
