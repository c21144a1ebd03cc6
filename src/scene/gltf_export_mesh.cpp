// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "scene/gltf_export_parts.h"

namespace lueur {
namespace {

static_assert(sizeof(Vertex) == 64, "vertices are written as they lie in memory");

// What glTF wants of each accessor of positions.
template <class T, class Projection = std::identity>
void set_range(OrderedJson& accessor, const std::vector<T>& values, Projection position = {}) {
  glm::vec3 low = std::invoke(position, values[0]), high = low;
  for (const T& value : values) {
    low = glm::min(low, std::invoke(position, value));
    high = glm::max(high, std::invoke(position, value));
  }
  accessor["min"] = vector_json(low);
  accessor["max"] = vector_json(high);
}

void add_influences(GlbWriter& glb, const Mesh& mesh, OrderedJson& attributes) {
  if (mesh.influences.empty()) return;
  std::vector<glm::u16vec4> joints;
  std::vector<glm::vec4> weights;
  for (const JointInfluence& influence : mesh.influences) {
    joints.push_back(influence.joints);
    weights.push_back(influence.weights);
    // A joint without weight has to be 0.
    for (int k = 0; k < 4; ++k)
      if (influence.weights[k] == 0.0f) joints.back()[k] = 0;
  }
  attributes["JOINTS_0"] = glb.add_array(joints, kGltfUint16, "VEC4", kGltfArrayBuffer);
  attributes["WEIGHTS_0"] = glb.add_array(weights, kGltfFloat, "VEC4", kGltfArrayBuffer);
}

OrderedJson add_morph_targets(GlbWriter& glb, const Mesh& mesh) {
  OrderedJson targets = OrderedJson::array();
  for (const MorphTarget& target : mesh.morph_targets) {
    OrderedJson object = OrderedJson::object();
    const auto add = [&](const char* key, const std::vector<glm::vec3>& values) {
      object[key] = glb.add_array(values, kGltfFloat, "VEC3", kGltfArrayBuffer);
    };
    // A target without any array is not allowed: one of zeros stands for it.
    std::vector<glm::vec3> positions = target.positions;
    if (positions.empty()) positions.resize(mesh.vertices.size(), glm::vec3(0.0f));
    add("POSITION", positions);
    set_range(glb.json()["accessors"].back(), positions);
    if (!target.normals.empty()) add("NORMAL", target.normals);
    targets.push_back(std::move(object));
  }
  return targets;
}

// One of the vertices' members, in the view that holds the vertices as they are.
int add_attribute(GlbWriter& glb, const Mesh& mesh, int view, size_t offset, const char* type,
                  int component = kGltfFloat) {
  return glb.add_accessor(view, offset, component, type, mesh.vertices.size());
}

bool reads_uv_2(const Material& m) {
  for (const TextureUse* use : {&m.base_color_texture, &m.metallic_roughness_texture,
                                &m.normal_texture, &m.emission_texture})
    if (use->is_used() && use->uv_set == 1) return true;
  return false;
}

// The attributes that all primitives of the mesh share. What all vertices have as if it were not
// there is not written, unless a material asks for it.
OrderedJson add_attributes(GlbWriter& glb, const Scene& scene, const Mesh& mesh, int view) {
  const auto any = [&](auto&& differs) {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), differs);
  };
  OrderedJson attributes = OrderedJson::object();
  const auto add = [&](const char* name, size_t offset, const char* type,
                       int component = kGltfFloat) {
    attributes[name] = add_attribute(glb, mesh, view, offset, type, component);
  };
  add("POSITION", offsetof(Vertex, position), "VEC3");
  set_range(glb.json()["accessors"].back(), mesh.vertices, &Vertex::position);
  add("NORMAL", offsetof(Vertex, normal), "VEC3");
  add("TEXCOORD_0", offsetof(Vertex, uv), "VEC2");
  const bool has_reader =
      std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                  [&](const Primitive& p) { return reads_uv_2(scene.materials[p.material]); });
  if (has_reader || any([](const Vertex& v) { return v.uv_2 != glm::vec2(0.0f); }))
    add("TEXCOORD_1", offsetof(Vertex, uv_2), "VEC2");
  if (any([](const Vertex& v) { return v.color != glm::u16vec4(kFullColor); })) {
    add("COLOR_0", offsetof(Vertex, color), "VEC4", kGltfUint16);
    glb.json()["accessors"].back()["normalized"] = true;
  }
  add_influences(glb, mesh, attributes);
  return attributes;
}

int add_mesh(GlbWriter& glb, const Scene& scene, const Mesh& mesh) {
  const int view =
      glb.add_view(GlbWriter::bytes_of(mesh.vertices), kGltfArrayBuffer, sizeof(Vertex));
  const OrderedJson shared = add_attributes(glb, scene, mesh, view);
  const OrderedJson targets = add_morph_targets(glb, mesh);
  const int index_view = glb.add_view(GlbWriter::bytes_of(mesh.indices), kGltfElementArrayBuffer);
  int tangent = kNone;
  OrderedJson primitives = OrderedJson::array();
  for (const Primitive& p : mesh.primitives) {
    if (p.index_count == 0) continue;
    OrderedJson attributes = shared;
    if (scene.materials[p.material].normal_texture.is_used()) {
      if (tangent == kNone)
        tangent = add_attribute(glb, mesh, view, offsetof(Vertex, tangent), "VEC4");
      attributes["TANGENT"] = tangent;
    }
    const int index = glb.add_accessor(index_view, size_t{p.first_index} * sizeof(uint32_t),
                                       kGltfUint32, "SCALAR", p.index_count);
    primitives.push_back(
        {{"attributes", std::move(attributes)}, {"indices", index}, {"material", p.material}});
    if (!targets.empty()) primitives.back()["targets"] = targets;
  }
  return glb.add_to("meshes", {{"name", mesh.name}, {"primitives", std::move(primitives)}});
}

}  // namespace

std::vector<int> export_meshes(GlbWriter& glb, const Scene& scene) {
  std::vector<int> mesh_index;
  for (const Mesh& mesh : scene.meshes) {
    bool has_triangles = false;
    for (const Primitive& p : mesh.primitives) has_triangles |= p.index_count > 0;
    mesh_index.push_back(has_triangles ? add_mesh(glb, scene, mesh) : kNone);
  }
  return mesh_index;
}

void export_skins(GlbWriter& glb, const Scene& scene) {
  for (const Skin& skin : scene.skins) {
    glb.add_to("skins",
               {{"name", skin.name},
                {"joints", skin.joints},
                {"inverseBindMatrices", glb.add_array(skin.joint_from_mesh, kGltfFloat, "MAT4")}});
  }
}

}  // namespace lueur
