// SPDX-License-Identifier: MIT
// How an OBJ file's polygons become meshes; see obj_geometry.h.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/try.h"
#include "scene/obj_geometry.h"
#include "scene/polygon.h"
#include "scene/vertex_frame.h"

namespace lueur {
namespace {

// What makes a vertex: corners alike in all of it share one.
struct VertexKey {
  ObjCorner corner;
  uint32_t transform = 0;  // place in the list of different UvTransforms
  auto tied() const { return std::tie(corner.position, corner.uv, corner.normal, transform); }
  bool operator<(const VertexKey& other) const { return tied() < other.tied(); }
  bool operator==(const VertexKey& other) const { return tied() == other.tied(); }
};

// Unit length, or 0 where it has none; in double precision, as areas of small polygons vanish.
glm::vec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f);
}

class MeshMaker {
 public:
  MeshMaker(ObjGeometry geometry, const std::vector<ObjMaterialUse>& materials,
            const std::string& file, const LoadLimits& limits, Warnings& warnings)
      : geometry_(std::move(geometry)),
        materials_(&materials),
        file_(&file),
        limits_(&limits),
        warnings_(&warnings) {}

  Result<std::vector<Mesh>> make();

 private:
  void make_normals();
  void make_smooth_normals();
  Result<Mesh> make_mesh(std::span<const uint32_t> faces);
  std::vector<VertexKey> keys_of(std::span<const uint32_t> faces);
  Vertex vertex_of(const VertexKey& key) const;
  void corner_positions(const ObjFace& face, std::vector<glm::vec3>& positions) const;
  uint32_t transform_of(uint32_t material);
  Error over_limit(uint64_t limit, const char* things) const;

  ObjGeometry geometry_;
  const std::vector<ObjMaterialUse>* materials_;
  const std::string* file_;
  const LoadLimits* limits_;
  Warnings* warnings_;
  std::vector<UvTransform> transforms_;
  std::vector<glm::vec3> positions_;  // of one polygon
  std::vector<uint32_t> triangles_;   // of one polygon
  uint64_t vertex_count_ = 0, index_count_ = 0;
};

void MeshMaker::corner_positions(const ObjFace& face, std::vector<glm::vec3>& positions) const {
  positions.clear();
  for (uint32_t i = 0; i < face.corner_count; ++i)
    positions.push_back(
        geometry_
            .positions[static_cast<size_t>(geometry_.corners[face.first_corner + i].position)]);
}

// Gives corners without a normal that of their smoothing group or of their face.
void MeshMaker::make_normals() {
  make_smooth_normals();
  for (const ObjFace& face : geometry_.faces) {
    int32_t normal = kNone;
    for (uint32_t i = 0; i < face.corner_count; ++i) {
      ObjCorner& corner = geometry_.corners[face.first_corner + i];
      if (corner.normal != kNone) continue;
      if (normal == kNone) {
        corner_positions(face, positions_);
        normal = static_cast<int32_t>(geometry_.normals.size());
        geometry_.normals.push_back(unit_or_zero(area_vector(positions_)));
      }
      corner.normal = normal;
    }
  }
}

// One normal for each position within each smoothing group: the sum of the faces' area vectors.
void MeshMaker::make_smooth_normals() {
  struct Smooth {
    uint32_t group;
    int32_t position;
    uint32_t corner;
    uint32_t face;
    bool operator<(const Smooth& o) const {
      return std::tie(group, position, corner) < std::tie(o.group, o.position, o.corner);
    }
  };
  std::vector<Smooth> wanted;
  for (uint32_t f = 0; f < geometry_.faces.size(); ++f) {
    const ObjFace& face = geometry_.faces[f];
    for (uint32_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i)
      if (face.smoothing != 0 && geometry_.corners[i].normal == kNone)
        wanted.push_back({face.smoothing, geometry_.corners[i].position, i, f});
  }
  if (wanted.empty()) return;
  std::vector<glm::dvec3> area_vectors;
  for (const ObjFace& face : geometry_.faces) {
    corner_positions(face, positions_);
    area_vectors.push_back(area_vector(positions_));
  }
  std::sort(wanted.begin(), wanted.end());
  for (size_t first = 0, last = 0; first < wanted.size(); first = last) {
    glm::dvec3 sum(0.0);
    const int32_t normal = static_cast<int32_t>(geometry_.normals.size());
    for (; last < wanted.size() && wanted[last].group == wanted[first].group &&
           wanted[last].position == wanted[first].position;
         ++last) {
      sum += area_vectors[wanted[last].face];
      geometry_.corners[wanted[last].corner].normal = normal;
    }
    geometry_.normals.push_back(unit_or_zero(sum));
  }
}

uint32_t MeshMaker::transform_of(uint32_t material) {
  const UvTransform& wanted = (*materials_)[material].uv;
  const auto known = std::find(transforms_.begin(), transforms_.end(), wanted);
  const size_t place = static_cast<size_t>(known - transforms_.begin());
  if (known == transforms_.end()) transforms_.push_back(wanted);
  return static_cast<uint32_t>(place);
}

// The corners of all these faces, one after the other.
std::vector<VertexKey> MeshMaker::keys_of(std::span<const uint32_t> faces) {
  std::vector<VertexKey> keys;
  uint32_t transform = 0, transform_material = UINT32_MAX;
  for (const uint32_t f : faces) {
    const ObjFace& face = geometry_.faces[f];
    if (face.material != transform_material) transform = transform_of(face.material);
    transform_material = face.material;
    for (uint32_t i = 0; i < face.corner_count; ++i)
      keys.push_back({geometry_.corners[face.first_corner + i], transform});
  }
  return keys;
}

Vertex MeshMaker::vertex_of(const VertexKey& key) const {
  Vertex vertex{};
  vertex.position = geometry_.positions[static_cast<size_t>(key.corner.position)];
  vertex.normal = geometry_.normals[static_cast<size_t>(key.corner.normal)];
  if (key.corner.uv == kNone) return vertex;
  const UvTransform& transform = transforms_[key.transform];
  constexpr float kFar = 1e9f;  // so that no product of hostile numbers is infinite
  const glm::vec2 given = geometry_.uvs[static_cast<size_t>(key.corner.uv)];
  const glm::vec2 uv = glm::clamp(given, -kFar, kFar) * transform.scale + transform.offset;
  vertex.uv = {uv.x, 1.0f - uv.y};  // the house's v points down
  return vertex;
}

Error MeshMaker::over_limit(uint64_t limit, const char* things) const {
  return {ErrorKind::input, *file_ + ": more than " + std::to_string(limit) + " " + things +
                                "; split the file, or raise the limit"};
}

Result<Mesh> MeshMaker::make_mesh(std::span<const uint32_t> faces) {
  const std::vector<VertexKey> keys = keys_of(faces);
  std::vector<VertexKey> different = keys;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  vertex_count_ += different.size();
  if (vertex_count_ > limits_->vertices) return over_limit(limits_->vertices, "vertices");

  Mesh mesh;
  mesh.vertices.reserve(different.size());
  for (const VertexKey& key : different) mesh.vertices.push_back(vertex_of(key));
  size_t first_key = 0;
  for (const uint32_t f : faces) {
    const ObjFace& face = geometry_.faces[f];
    corner_positions(face, positions_);
    triangles_.clear();
    if (!triangulate(positions_, triangles_))
      warnings_->add("polygons that cross themselves are cut into triangles somehow");
    index_count_ += triangles_.size();
    if (index_count_ > limits_->indices) return over_limit(limits_->indices, "indices");
    const int32_t material = (*materials_)[face.material].material;
    if (mesh.primitives.empty() || mesh.primitives.back().material != material)
      mesh.primitives.push_back({static_cast<uint32_t>(mesh.indices.size()), 0, material});
    mesh.primitives.back().index_count += static_cast<uint32_t>(triangles_.size());
    for (const uint32_t corner : triangles_) {
      const auto found =
          std::lower_bound(different.begin(), different.end(), keys[first_key + corner]);
      mesh.indices.push_back(static_cast<uint32_t>(found - different.begin()));
    }
    first_key += face.corner_count;
  }
  std::erase_if(mesh.primitives, [](const Primitive& p) { return p.index_count == 0; });
  if (repair_normals(mesh.vertices, mesh.indices) > 0)
    warnings_->add("normals of length 0 are replaced by the mean of their faces' normals");
  make_tangents(mesh.vertices, mesh.indices);
  return mesh;
}

Result<std::vector<Mesh>> MeshMaker::make() {
  make_normals();
  // Bring together what is one mesh, and in it what has one material; else keep the file's order.
  std::vector<uint32_t> order(geometry_.faces.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const ObjFace &x = geometry_.faces[a], &y = geometry_.faces[b];
    return std::tie(x.mesh, x.material) < std::tie(y.mesh, y.material);
  });
  std::vector<Mesh> meshes;
  for (size_t first = 0, last = 0; first < order.size(); first = last) {
    const uint32_t mesh_index = geometry_.faces[order[first]].mesh;
    while (last < order.size() && geometry_.faces[order[last]].mesh == mesh_index) ++last;
    LUEUR_TRY(mesh, make_mesh(std::span(order).subspan(first, last - first)));
    mesh.name = geometry_.mesh_names[mesh_index];
    if (!mesh.primitives.empty()) meshes.push_back(std::move(mesh));
  }
  return meshes;
}

}  // namespace

Result<std::vector<Mesh>> make_obj_meshes(ObjGeometry geometry,
                                          const std::vector<ObjMaterialUse>& materials,
                                          const std::string& file, const LoadLimits& limits,
                                          Warnings& warnings) {
  return MeshMaker(std::move(geometry), materials, file, limits, warnings).make();
}

}  // namespace lueur
