// SPDX-License-Identifier: MIT
#include "scene/builtin/scene_builder.h"

#include <cmath>
#include <utility>

#include "base/check.h"
#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

glm::quat look_along(glm::vec3 direction) {
  const glm::vec3 back = -glm::normalize(direction);
  const glm::vec3 up = std::abs(back.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
  const glm::vec3 right = glm::normalize(glm::cross(up, back));
  return glm::normalize(glm::quat_cast(glm::mat3(right, glm::cross(back, right), back)));
}

int32_t add_node(Scene& scene, std::string name, glm::vec3 translation, glm::quat rotation,
                 int32_t parent) {
  Node node;
  node.name = std::move(name);
  node.parent = parent;
  node.translation = translation;
  node.rotation = rotation;
  scene.nodes.push_back(std::move(node));
  return int32_t(scene.nodes.size()) - 1;
}

int32_t add_material(Scene& scene, std::string name, glm::vec3 albedo, float roughness) {
  Material material;
  material.name = std::move(name);
  material.base_color = glm::vec4(albedo, 1.0f);
  material.metallic = 0.0f;
  material.roughness = roughness;
  scene.materials.push_back(std::move(material));
  return int32_t(scene.materials.size()) - 1;
}

int32_t add_mesh(Scene& scene, Mesh mesh) {
  const int32_t node = add_node(scene, mesh.name);
  scene.meshes.push_back(std::move(mesh));
  add_instance(scene, int32_t(scene.meshes.size()) - 1, node);
  return node;
}

void add_instance(Scene& scene, int32_t mesh, int32_t node) {
  scene.instances.push_back({node, mesh});
}

int32_t add_camera(Scene& scene, std::string name, glm::vec3 eye, glm::vec3 target,
                   float vertical_fov_rad) {
  const int32_t node = add_node(scene, name, eye, look_along(target - eye));
  Camera camera;
  camera.name = std::move(name);
  camera.node = node;
  camera.vertical_fov_rad = vertical_fov_rad;
  scene.cameras.push_back(std::move(camera));
  return node;
}

int32_t add_spot_light(Scene& scene, std::string name, glm::vec3 from, glm::vec3 to,
                       glm::vec3 color, float lux, float outer_cone_rad) {
  Light spot;
  spot.kind = LightKind::spot;
  spot.node = add_node(scene, name, from, look_along(to - from));
  spot.name = std::move(name);
  spot.color = color;
  spot.intensity = lux * glm::dot(to - from, to - from);
  spot.inner_cone_rad = 0.5f * outer_cone_rad;
  spot.outer_cone_rad = outer_cone_rad;
  const int32_t node = spot.node;
  scene.lights.push_back(std::move(spot));
  return node;
}

void animate_translation(Scene& scene, int32_t node, int keys,
                         const std::function<glm::vec3(float phase)>& translation) {
  AnimationChannel channel;
  channel.node = node;
  channel.path = AnimationPath::translation;
  for (int k = 0; k <= keys; ++k) {
    channel.times_s.push_back(kLoopSeconds * float(k) / float(keys));
    channel.values.emplace_back(translation(float(k % keys) / float(keys)), 0.0f);
  }
  scene.nodes[node].translation = glm::vec3(channel.values[0]);
  scene.animation.push_back(std::move(channel));
}

void animate_rotation(Scene& scene, int32_t node, int keys,
                      const std::function<glm::quat(float phase)>& rotation) {
  AnimationChannel channel;
  channel.node = node;
  channel.path = AnimationPath::rotation;
  glm::quat previous = rotation(0.0f);
  scene.nodes[node].rotation = previous;
  for (int k = 0; k <= keys; ++k) {
    glm::quat q = rotation(float(k % keys) / float(keys));

    // Keep to the same half of the quaternions, so that each step turns the short way.
    if (glm::dot(q, previous) < 0.0f) q = -q;
    previous = q;
    channel.times_s.push_back(kLoopSeconds * float(k) / float(keys));
    channel.values.emplace_back(q.x, q.y, q.z, q.w);
  }
  scene.animation.push_back(std::move(channel));
}

void animate_camera(Scene& scene, int32_t node, int keys,
                    const std::function<glm::vec3(float phase)>& eye,
                    const std::function<glm::vec3(float phase)>& target) {
  animate_translation(scene, node, keys, eye);
  animate_rotation(scene, node, keys,
                   [&](float phase) { return look_along(target(phase) - eye(phase)); });
}

float exposure_for(float albedo, float illuminance_lux) {
  LUEUR_CHECK_OP(albedo * illuminance_lux, >, 0.0f);
  return std::log2(0.9f * kPi / (albedo * illuminance_lux));
}

}  // namespace lueur::builtin
