// SPDX-License-Identifier: MIT
#include "scene/gltf_vertices.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/gltf_accessor.h"
#include "scene/vertex_frame.h"

namespace lueur {
namespace {

constexpr uint64_t kMaxTargets = 1024;

// Reads one primitive's accessors, naming the attribute and the mesh where one does not fit.
class AttributeReader {
 public:
  AttributeReader(const GltfFile& file, uint64_t count, const std::string& mesh_name)
      : file_(&file), count_(count), mesh_name_(&mesh_name) {}

  // count * components floats, or none where there is no accessor.
  Result<std::vector<float>> read(const JsonCursor& attributes, const char* key, int32_t accessor,
                                  uint32_t components) const {
    if (accessor == kNone) return std::vector<float>();
    LUEUR_TRY(shape, accessor_shape(*file_, accessor));
    if (shape.components != components)
      return attributes.error(key, "has to be a VEC" + std::to_string(components));
    return read_any(attributes, key, accessor, shape);
  }

  Result<std::vector<glm::vec3>> read_vec3(const JsonCursor& attributes, const char* key,
                                           int32_t accessor) const {
    LUEUR_TRY(values, read(attributes, key, accessor, 3));
    std::vector<glm::vec3> vectors(values.size() / 3);
    for (size_t i = 0; i < vectors.size(); ++i)
      vectors[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
    return vectors;
  }

  // RGB or RGBA as RGBA.
  Result<std::vector<glm::vec4>> read_colors(const JsonCursor& attributes, int32_t accessor) const {
    std::vector<glm::vec4> colors;
    if (accessor == kNone) return colors;
    LUEUR_TRY(shape, accessor_shape(*file_, accessor));
    if (shape.components != 3 && shape.components != 4)
      return attributes.error("COLOR_0", "has to be a VEC3 or VEC4");
    LUEUR_TRY(values, read_any(attributes, "COLOR_0", accessor, shape));
    for (size_t i = 0; i < values.size(); i += shape.components)
      colors.emplace_back(values[i], values[i + 1], values[i + 2],
                          shape.components == 4 ? values[i + 3] : 1.0f);
    return colors;
  }

 private:
  Result<std::vector<float>> read_any(const JsonCursor& attributes, const char* key,
                                      int32_t accessor, const AccessorShape& shape) const {
    if (shape.count != count_)
      return attributes.error(key, std::to_string(shape.count) + " elements for " +
                                       std::to_string(count_) + " positions; re-export the file");
    LUEUR_TRY(values, read_floats(*file_, accessor));
    for (size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        return attributes.error(key, "vertex " + std::to_string(i / shape.components) +
                                         " of mesh '" + printable(*mesh_name_) +
                                         "' is not finite; repair and re-export the model");
    return std::move(values);
  }

  const GltfFile* file_;
  uint64_t count_;
  const std::string* mesh_name_;
};

std::string uv_key(uint32_t set) {
  return "TEXCOORD_" + std::to_string(set);
}

// Reads the four joints of each vertex and makes their weights sum up to 1.
Result<std::vector<JointInfluence>> read_influences(const AttributeReader& reader,
                                                    const JsonCursor& attributes,
                                                    const VertexAccessors& accessors,
                                                    Warnings& warnings) {
  LUEUR_TRY(joints, reader.read(attributes, "JOINTS_0", accessors.joints, 4));
  LUEUR_TRY(weights, reader.read(attributes, "WEIGHTS_0", accessors.weights, 4));
  std::vector<JointInfluence> influences(joints.empty() || weights.empty() ? 0 : joints.size() / 4);
  for (size_t i = 0; i < influences.size(); ++i) {
    JointInfluence& influence = influences[i];
    float sum = 0.0f;
    for (size_t k = 0; k < 4; ++k) {
      const float joint = joints[4 * i + k];
      if (!(joint >= 0.0f && joint <= 65535.0f && joint == std::floor(joint)))
        return attributes.error(
            "JOINTS_0", "vertex " + std::to_string(i) + " names no joint; re-export the file");
      const int c = static_cast<int>(k);
      influence.joints[c] = static_cast<uint16_t>(joint);
      influence.weights[c] = weights[4 * i + k];
      if (influence.weights[c] < 0.0f)
        return attributes.error("WEIGHTS_0", "vertex " + std::to_string(i) +
                                                 " has a negative weight; re-export the file");
      sum += influence.weights[c];
    }
    if (!(sum > 0.0f && std::isfinite(sum))) {
      warnings.add("vertices whose joints have no weight follow their first joint");
      influence.weights = {1.0f, 0.0f, 0.0f, 0.0f};
    } else {
      influence.weights /= sum;
    }
  }
  return influences;
}

uint16_t unorm16(float value) {
  return static_cast<uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * float{kFullColor}));
}

template <class T>
void gather(std::vector<T>& values, const std::vector<uint32_t>& corners) {
  if (values.empty()) return;
  std::vector<T> gathered;
  gathered.reserve(corners.size());
  for (const uint32_t corner : corners) gathered.push_back(values[corner]);
  values = std::move(gathered);
}

}  // namespace

Result<VertexAccessors> find_vertices(const GltfFile& file, const JsonCursor& primitive,
                                      const std::array<std::optional<uint32_t>, 2>& uv_sets,
                                      Warnings& warnings) {
  const size_t count = file.size_of("accessors");
  VertexAccessors found;
  const auto find = [&](const JsonCursor& attributes, const char* key,
                        int32_t& accessor) -> Result<void> {
    LUEUR_TRY(index, attributes.index(key, count, "accessors"));
    accessor = index;
    return {};
  };
  LUEUR_TRY(attributes, primitive.object("attributes"));
  LUEUR_TRY_VOID(find(attributes, "POSITION", found.position));
  LUEUR_TRY_VOID(find(attributes, "NORMAL", found.normal));
  // Tangents without the normals they belong to say nothing.
  if (found.normal != kNone) LUEUR_TRY_VOID(find(attributes, "TANGENT", found.tangent));
  for (size_t slot = 0; slot < uv_sets.size(); ++slot)
    if (uv_sets[slot]) {
      found.uv_sets[slot] = *uv_sets[slot];
      LUEUR_TRY_VOID(find(attributes, uv_key(*uv_sets[slot]).c_str(), found.uv[slot]));
    }
  LUEUR_TRY_VOID(find(attributes, "COLOR_0", found.color));
  LUEUR_TRY_VOID(find(attributes, "JOINTS_0", found.joints));
  LUEUR_TRY_VOID(find(attributes, "WEIGHTS_0", found.weights));
  if (attributes.has("COLOR_1")) warnings.add("only the first set of vertex colours is drawn");
  if (attributes.has("JOINTS_1")) warnings.add("only the first four joints of a vertex move it");

  LUEUR_TRY(targets, primitive.array("targets"));
  if (targets.size() > kMaxTargets)
    return primitive.error(
        "targets", "more than " + std::to_string(kMaxTargets) + " morph targets; remove some");
  for (size_t i = 0; i < targets.size(); ++i) {
    LUEUR_TRY(target, targets.element(i));
    VertexAccessors::Target& read = found.targets.emplace_back();
    LUEUR_TRY_VOID(find(target, "POSITION", read.position));
    if (found.normal != kNone) LUEUR_TRY_VOID(find(target, "NORMAL", read.normal));
    if (found.tangent != kNone) LUEUR_TRY_VOID(find(target, "TANGENT", read.tangent));
    if (target.has("TEXCOORD_0") || target.has("COLOR_0"))
      warnings.add("morphing of colours and texture coordinates is not supported: they stay");
  }
  return found;
}

Result<PrimitiveVertices> read_vertices(const GltfFile& file, const JsonCursor& at,
                                        const VertexAccessors& accessors, uint64_t count,
                                        const std::string& mesh_name, Warnings& warnings) {
  const AttributeReader reader(file, count, mesh_name);
  PrimitiveVertices result;
  result.vertices.resize(count);
  std::vector<Vertex>& vertices = result.vertices;
  LUEUR_TRY(attributes, at.object("attributes"));

  // One attribute at a time: only one array of floats lives beside the vertices.
  {
    LUEUR_TRY(positions, reader.read_vec3(attributes, "POSITION", accessors.position));
    for (size_t i = 0; i < positions.size(); ++i) vertices[i].position = positions[i];
  }
  {
    LUEUR_TRY(normals, reader.read_vec3(attributes, "NORMAL", accessors.normal));
    for (size_t i = 0; i < normals.size(); ++i) vertices[i].normal = normals[i];
  }
  {
    LUEUR_TRY(values, reader.read(attributes, "TANGENT", accessors.tangent, 4));
    for (size_t i = 0; 4 * i < values.size(); ++i)
      vertices[i].tangent = {values[4 * i], values[4 * i + 1], values[4 * i + 2],
                             values[4 * i + 3]};
  }
  for (size_t slot = 0; slot < accessors.uv.size(); ++slot) {
    const std::string key = uv_key(accessors.uv_sets[slot]);
    LUEUR_TRY(values, reader.read(attributes, key.c_str(), accessors.uv[slot], 2));
    glm::vec2 Vertex::*const uv = slot == 0 ? &Vertex::uv : &Vertex::uv_2;
    for (size_t i = 0; 2 * i < values.size(); ++i)
      vertices[i].*uv = {values[2 * i], values[2 * i + 1]};
  }
  {
    LUEUR_TRY(colors, reader.read_colors(attributes, accessors.color));
    for (size_t i = 0; i < colors.size(); ++i)
      for (int c = 0; c < 4; ++c) vertices[i].color[c] = unorm16(colors[i][c]);
  }
  LUEUR_TRY(influences, read_influences(reader, attributes, accessors, warnings));
  result.influences = std::move(influences);

  LUEUR_TRY(targets, at.array("targets"));
  for (size_t t = 0; t < accessors.targets.size(); ++t) {
    LUEUR_TRY(target, targets.element(t));
    LUEUR_TRY(positions, reader.read_vec3(target, "POSITION", accessors.targets[t].position));
    LUEUR_TRY(normals, reader.read_vec3(target, "NORMAL", accessors.targets[t].normal));
    LUEUR_TRY(tangents, reader.read_vec3(target, "TANGENT", accessors.targets[t].tangent));
    result.targets.push_back({std::move(positions), std::move(normals), std::move(tangents)});
  }
  return result;
}

void split_flat(PrimitiveVertices& primitive, std::vector<uint32_t>& corners) {
  gather(primitive.vertices, corners);
  gather(primitive.influences, corners);
  for (MorphTarget& target : primitive.targets) {
    gather(target.positions, corners);
    gather(target.normals, corners);
    gather(target.tangents, corners);
  }
  std::iota(corners.begin(), corners.end(), 0u);
  make_flat_normals(primitive.vertices);
}

}  // namespace lueur
