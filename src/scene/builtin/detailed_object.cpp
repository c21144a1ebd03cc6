// SPDX-License-Identifier: MIT
#include "scene/builtin/detailed_object.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.h"
#include "scene/builtin/dragon.h"
#include "scene/builtin/room_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/deform.h"

namespace lueur::builtin {
namespace {

constexpr std::string_view kObjectName = "detailed object";

// Unglazed porcelain: pale, so that it shows the colour of the light that reaches it.
Pattern porcelain_pattern() {
  return {[](glm::vec2 uv) {
            return glm::mix(glm::vec3(0.80f, 0.76f, 0.69f), glm::vec3(0.90f, 0.88f, 0.84f),
                            tiling_noise(uv, 5, 5, 91));
          },
          [](glm::vec2 uv) { return 0.0012f * tiling_noise(uv, 40, 3, 92); }};
}

std::vector<MeshInstance>::const_iterator find_object(const Scene& scene) {
  return std::find_if(scene.instances.begin(), scene.instances.end(), [&](const MeshInstance& i) {
    return scene.meshes[i.mesh].name == kObjectName;
  });
}

// Adds all that `other` draws, its roots on the node `parent`.
void append(Scene& scene, Scene other, int32_t parent) {
  const auto moved = [](int32_t& index, size_t by) {
    if (index != kNone) index += int32_t(by);
  };
  const size_t textures = scene.textures.size(), materials = scene.materials.size();
  const size_t meshes = scene.meshes.size(), nodes = scene.nodes.size();
  for (Texture& texture : other.textures) scene.textures.push_back(std::move(texture));
  for (Material& material : other.materials) {
    for (TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                            &material.normal_texture, &material.emission_texture})
      moved(use->texture, textures);
    scene.materials.push_back(std::move(material));
  }
  for (Mesh& mesh : other.meshes) {
    for (Primitive& primitive : mesh.primitives) moved(primitive.material, materials);
    scene.meshes.push_back(std::move(mesh));
  }
  for (Node& node : other.nodes) {
    node.parent = node.parent == kNone ? parent : node.parent + int32_t(nodes);
    scene.nodes.push_back(std::move(node));
  }
  for (const MeshInstance& instance : other.instances)
    scene.instances.push_back({instance.node + int32_t(nodes), instance.mesh + int32_t(meshes)});
  for (std::string& warning : other.warnings) scene.warnings.push_back(std::move(warning));
}

}  // namespace

void add_detailed_object(Scene& scene, const DetailedObject& object, int32_t parent) {
  LUEUR_CHECK(!has_detailed_object(scene));
  const int32_t material = add_patterned_material(scene, "porcelain", glm::vec3(1.0f), 0.55f, 256,
                                                  0.8f, porcelain_pattern());
  MeshBuilder builder;
  builder.set_material(material, 0.8f);
  add_dragon(builder, object.triangles);
  const int32_t node = add_mesh(scene, builder.finish(std::string(kObjectName)));
  scene.nodes[node].parent = parent;
  float top = 0.0f;
  for (const Vertex& v : scene.meshes.back().vertices) top = std::max(top, v.position.y);
  scene.nodes[node].scale = glm::vec3(object.height_m / top);
}

bool has_detailed_object(const Scene& scene) {
  return find_object(scene) != scene.instances.end();
}

bool replace_detailed_object(Scene& scene, Scene other) {
  const auto found = find_object(scene);
  LUEUR_CHECK(found != scene.instances.end());
  const MeshInstance object = *found;

  // Find the box to fit, in the space in which the object stands.
  const Node& stand = scene.nodes[object.node];
  Bounds box{glm::vec3(1e30f), glm::vec3(-1e30f)};
  for (const Vertex& v : scene.meshes[object.mesh].vertices) {
    const glm::vec3 p = stand.translation + stand.rotation * (stand.scale * v.position);
    box = {glm::min(box.min, p), glm::max(box.max, p)};
  }
  // Take it as it is at rest.
  other = with_deformed_meshes(std::move(other), 0.0f);
  other.animation.clear();
  const Bounds others = bounds_at(other, 0.0f);
  const glm::vec3 share = (box.max - box.min) / (others.max - others.min);
  const float scale = std::min({share.x, share.y, share.z});
  if (!std::isfinite(scale) || scale <= 0.0f) return false;

  // Put its own mesh away, and what comes behind what is there.
  const auto foot = [](const Bounds& b) {
    const glm::vec3 middle = 0.5f * (b.min + b.max);
    return glm::vec3(middle.x, b.min.y, middle.z);
  };
  const int32_t fit = add_node(scene, "object", foot(box) - scale * foot(others),
                               glm::quat(1, 0, 0, 0), stand.parent);
  scene.nodes[fit].scale = glm::vec3(scale);
  scene.instances.erase(found);
  scene.meshes.erase(scene.meshes.begin() + object.mesh);
  for (MeshInstance& instance : scene.instances) instance.mesh -= instance.mesh > object.mesh;
  append(scene, std::move(other), fit);
  return true;
}

}  // namespace lueur::builtin
