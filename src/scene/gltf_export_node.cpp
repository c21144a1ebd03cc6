// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "scene/gltf_export_parts.h"
#include "scene/gltf_instance.h"

namespace lueur {
namespace {

void add_cameras(GlbWriter& glb, const Scene& scene) {
  for (const Camera& camera : scene.cameras)
    glb.add_to("cameras",
               {{"name", camera.name},
                {"type", "perspective"},
                {"perspective", {{"yfov", camera.vertical_fov_rad}, {"znear", camera.near_m}}}});
}

void add_lights(GlbWriter& glb, const Scene& scene) {
  if (scene.lights.empty()) return;
  glb.use_extension("KHR_lights_punctual");
  OrderedJson lights = OrderedJson::array();
  for (const Light& light : scene.lights) {
    OrderedJson object = {{"name", light.name},
                          {"type", light.kind == LightKind::point  ? "point"
                                   : light.kind == LightKind::spot ? "spot"
                                                                   : "directional"},
                          {"color", vector_json(light.color)},
                          {"intensity", light.intensity}};
    if (std::isfinite(light.range_m)) object["range"] = light.range_m;
    if (light.kind == LightKind::spot)
      object["spot"] = {{"innerConeAngle", light.inner_cone_rad},
                        {"outerConeAngle", light.outer_cone_rad}};
    lights.push_back(std::move(object));
  }
  glb.json()["extensions"]["KHR_lights_punctual"]["lights"] = std::move(lights);
}

void set_transform(OrderedJson& object, const Node& node) {
  if (node.translation != glm::vec3(0.0f)) object["translation"] = vector_json(node.translation);
  const glm::quat q = node.rotation;
  if (q != glm::quat(1, 0, 0, 0)) object["rotation"] = OrderedJson::array({q.x, q.y, q.z, q.w});
  if (node.scale != glm::vec3(1.0f)) object["scale"] = vector_json(node.scale);
}

class NodeExport {
 public:
  NodeExport(GlbWriter& glb, const Scene& scene) : glb_(glb), scene_(scene) {}

  void write(const std::vector<int>& mesh_index) {
    add_own_nodes();
    fill_nodes(mesh_index);
    link_nodes();
  }

 private:
  void add_own_nodes() {
    for (const Node& node : scene_.nodes) {
      OrderedJson object = {{"name", node.name}};
      if (node.matrix) {
        for (int column = 0; column < 4; ++column)
          for (int row = 0; row < 4; ++row) object["matrix"].push_back((*node.matrix)[column][row]);
      } else {
        set_transform(object, node);
      }
      glb_.add_to("nodes", std::move(object));
    }
  }

  // Meshes, cameras and lights.
  void fill_nodes(const std::vector<int>& mesh_index) {
    for (const MeshInstance& instance : scene_.instances)
      if (mesh_index[instance.mesh] != kNone) {
        OrderedJson& node = node_for(instance.node, "mesh");
        node["mesh"] = mesh_index[instance.mesh];
        if (!instance.passes_light_on) node["extras"] = {{kPassesLightOnKey, false}};
        if (instance.skin != kNone) node["skin"] = instance.skin;
        if (!instance.morph_weights.empty()) node["weights"] = instance.morph_weights;
      }
    for (size_t k = 0; k < scene_.cameras.size(); ++k)
      node_for(scene_.cameras[k].node, "camera")["camera"] = k;
    for (size_t k = 0; k < scene_.lights.size(); ++k)
      node_for(scene_.lights[k].node,
               "extensions")["extensions"]["KHR_lights_punctual"] = {{"light", k}};
  }

  // The node itself if its slot is free, else a new child of it.
  OrderedJson& node_for(int32_t node, const char* slot) {
    if (!glb_.json()["nodes"][node].contains(slot)) return glb_.json()["nodes"][node];
    extra_children_.emplace_back(node, glb_.add_to("nodes", {{"name", scene_.nodes[node].name}}));
    return glb_.json()["nodes"].back();
  }

  void link_nodes() {
    OrderedJson root = {{"name", scene_.name}};
    for (size_t k = 0; k < scene_.nodes.size(); ++k) {
      const int32_t parent = scene_.nodes[k].parent;
      (parent == kNone ? root["nodes"] : glb_.json()["nodes"][parent]["children"]).push_back(k);
    }
    for (const auto& [parent, child] : extra_children_)
      glb_.json()["nodes"][parent]["children"].push_back(child);
    glb_.add_to("scenes", std::move(root));
    glb_.json()["scene"] = 0;
  }

  GlbWriter& glb_;
  const Scene& scene_;
  std::vector<std::pair<int, int>> extra_children_;  // parent and child
};

}  // namespace

void export_nodes(GlbWriter& glb, const Scene& scene, const std::vector<int>& mesh_index) {
  add_cameras(glb, scene);
  add_lights(glb, scene);
  NodeExport(glb, scene).write(mesh_index);
}

}  // namespace lueur
