// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "fuzz_input.h"
#include "scene/deform.h"
#include "scene/framing.h"

namespace lueur {
namespace {

bool is_unit(const glm::vec3& v) {
  return std::abs(glm::length(v) - 1.0f) < 1e-3f;
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_mesh(const Mesh& mesh, size_t material_count) {
  for (const uint32_t index : mesh.indices) LUEUR_CHECK_OP(index, <, mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    LUEUR_CHECK(is_finite(vertex.position));
    LUEUR_CHECK(is_unit(vertex.normal));
    LUEUR_CHECK(is_unit(glm::vec3(vertex.tangent)));
    LUEUR_CHECK(std::abs(vertex.tangent.w) == 1.0f);
  }
  for (const Primitive& primitive : mesh.primitives) {
    LUEUR_CHECK_OP(primitive.index_count % 3, ==, 0u);
    LUEUR_CHECK_OP(uint64_t{primitive.first_index} + primitive.index_count, <=,
                   mesh.indices.size());
    LUEUR_CHECK_OP(static_cast<size_t>(primitive.material), <, material_count);
  }
  const auto fits = [&](size_t size) { return size == 0 || size == mesh.vertices.size(); };
  LUEUR_CHECK(fits(mesh.influences.size()));
  for (const MorphTarget& target : mesh.morph_targets)
    LUEUR_CHECK(fits(target.positions.size()) && fits(target.normals.size()) &&
                fits(target.tangents.size()));
}

void check_material(const Material& material, size_t texture_count) {
  for (const TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                                &material.normal_texture, &material.emission_texture}) {
    if (use->is_used()) LUEUR_CHECK_OP(static_cast<size_t>(use->texture), <, texture_count);
    LUEUR_CHECK_OP(use->uv_set, <, 2u);
  }
}

// Each vertex follows joints that the skin has, and the skin nodes that the scene has.
void check_skin(const Scene& scene, const MeshInstance& instance) {
  if (instance.skin == kNone) return;
  LUEUR_CHECK_OP(static_cast<size_t>(instance.skin), <, scene.skins.size());
  const Skin& skin = scene.skins[static_cast<size_t>(instance.skin)];
  LUEUR_CHECK_OP(skin.joints.size(), ==, skin.joint_from_mesh.size());
  for (const int32_t joint : skin.joints)
    LUEUR_CHECK_OP(static_cast<size_t>(joint), <, scene.nodes.size());
  const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
  LUEUR_CHECK_OP(mesh.influences.size(), ==, mesh.vertices.size());
  for (const JointInfluence& influence : mesh.influences)
    for (int k = 0; k < 4; ++k) LUEUR_CHECK_OP(influence.joints[k], <, skin.joints.size());
}

// Animation, which files are free to make absurd, keeps all that is drawn within floats.
void check_time(const Scene& scene, float time_s) {
  const std::vector<glm::mat4> world = pose(scene, time_s);
  for (const glm::mat4& matrix : world) LUEUR_CHECK(lueur::is_finite(matrix));
  const std::vector<DeformedInstance> deformed = deformed_instances(scene, world, time_s);
  for (const DeformedInstance& instance : deformed)
    for (const Vertex& vertex : instance.vertices) {
      LUEUR_CHECK(is_finite(vertex.position));
      LUEUR_CHECK(is_unit(vertex.normal));
      LUEUR_CHECK(is_unit(glm::vec3(vertex.tangent)));
    }
  const Bounds box = bounds(scene, world, deformed);
  LUEUR_CHECK(is_finite(box.min) && is_finite(box.max));
}

}  // namespace

void check_scene(const Scene& scene) {
  LUEUR_CHECK(!scene.materials.empty());
  for (size_t i = 0; i < scene.nodes.size(); ++i)
    LUEUR_CHECK_OP(scene.nodes[i].parent, <, static_cast<int32_t>(i));
  for (const Material& material : scene.materials) check_material(material, scene.textures.size());
  for (const Mesh& mesh : scene.meshes) check_mesh(mesh, scene.materials.size());
  for (const MeshInstance& instance : scene.instances) {
    LUEUR_CHECK_OP(static_cast<size_t>(instance.mesh), <, scene.meshes.size());
    LUEUR_CHECK_OP(static_cast<size_t>(instance.node), <, scene.nodes.size());
    check_skin(scene, instance);
  }
  for (const Texture& texture : scene.textures)
    LUEUR_CHECK_OP(texture.rgba.size(), ==, size_t{texture.width} * texture.height * 4);
  float duration_s = 0.0f;
  for (const AnimationChannel& channel : scene.animation)
    for (const float time_s : channel.times_s) duration_s = std::max(duration_s, time_s);
  check_time(scene, 0.0f);
  if (duration_s > 0.0f) check_time(scene, 0.4f * duration_s);
}

void check_completed(const Scene& scene) {
  Scene completed = scene;
  complete(completed);
  LUEUR_CHECK(!completed.cameras.empty());
}

}  // namespace lueur
