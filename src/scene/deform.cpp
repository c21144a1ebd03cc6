// SPDX-License-Identifier: MIT
#include "scene/deform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lueur {
namespace {

const Bounds kAroundNothing{glm::vec3(std::numeric_limits<float>::infinity()),
                            glm::vec3(-std::numeric_limits<float>::infinity())};

// Adds what the targets move; normals and tangents are not unit length afterwards.
void morph(const Mesh& mesh, const std::vector<float>& weights, std::vector<Vertex>& vertices) {
  for (size_t t = 0; t < weights.size(); ++t) {
    const MorphTarget& target = mesh.morph_targets[t];
    const float weight = weights[t];
    if (weight == 0.0f) continue;
    for (size_t i = 0; i < target.positions.size(); ++i)
      vertices[i].position += weight * target.positions[i];
    for (size_t i = 0; i < target.normals.size(); ++i)
      vertices[i].normal += weight * target.normals[i];
    for (size_t i = 0; i < target.tangents.size(); ++i)
      vertices[i].tangent += glm::vec4(weight * target.tangents[i], 0.0f);
  }
}

// What the linear map does to normals, up to a positive factor: also right where it has no inverse.
glm::mat3 cofactors(const glm::mat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void skin(const Mesh& mesh, const Skin& skin, const std::vector<glm::mat4>& world_from_node,
          std::vector<Vertex>& vertices) {
  std::vector<glm::mat4> world_from_mesh;
  for (size_t j = 0; j < skin.joints.size(); ++j)
    world_from_mesh.push_back(world_from_node[static_cast<size_t>(skin.joints[j])] *
                              skin.joint_from_mesh[j]);
  for (size_t i = 0; i < vertices.size(); ++i) {
    const JointInfluence& influence = mesh.influences[i];
    glm::mat4 blended(0.0f);
    for (int k = 0; k < 4; ++k)
      if (influence.weights[k] != 0.0f)
        blended += influence.weights[k] * world_from_mesh[influence.joints[k]];
    Vertex& vertex = vertices[i];
    const glm::mat3 linear(blended);
    vertex.position = glm::vec3(blended * glm::vec4(vertex.position, 1.0f));
    vertex.normal = cofactors(linear) * vertex.normal;
    vertex.tangent = glm::vec4(linear * glm::vec3(vertex.tangent), vertex.tangent.w);
  }
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& fallback) {
  // In double precision: squares of tiny and of huge vectors leave the range of floats.
  const glm::dvec3 wide(v);
  const double length = glm::length(wide);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(wide / length) : fallback;
}

std::vector<Vertex> deformed_vertices(const Scene& scene, const MeshInstance& instance,
                                      const std::vector<glm::mat4>& world_from_node,
                                      const std::vector<float>& weights) {
  const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
  std::vector<Vertex> vertices = mesh.vertices;
  morph(mesh, weights, vertices);
  if (instance.skin != kNone)
    skin(mesh, scene.skins[static_cast<size_t>(instance.skin)], world_from_node, vertices);
  for (size_t i = 0; i < vertices.size(); ++i) {
    Vertex& vertex = vertices[i];
    if (!is_finite(vertex.position)) vertex.position = mesh.vertices[i].position;
    vertex.normal = unit_or(vertex.normal, mesh.vertices[i].normal);
    const glm::vec3 tangent = unit_or(glm::vec3(vertex.tangent), mesh.vertices[i].tangent);
    vertex.tangent = glm::vec4(tangent, vertex.tangent.w);
  }
  return vertices;
}

}  // namespace

bool is_deformed(const Scene& scene, const MeshInstance& instance) {
  return instance.skin != kNone ||
         !scene.meshes[static_cast<size_t>(instance.mesh)].morph_targets.empty();
}

glm::mat4 world_from_instance(const MeshInstance& instance,
                              const std::vector<glm::mat4>& world_from_node) {
  return instance.skin != kNone ? glm::mat4(1.0f)
                                : world_from_node[static_cast<size_t>(instance.node)];
}

std::vector<DeformedInstance> deformed_instances(const Scene& scene,
                                                 const std::vector<glm::mat4>& world_from_node,
                                                 float time_s) {
  const std::vector<std::vector<float>> weights = morph_weights(scene, time_s);
  std::vector<DeformedInstance> deformed;
  for (size_t i = 0; i < scene.instances.size(); ++i)
    if (is_deformed(scene, scene.instances[i]))
      deformed.push_back(
          {i, deformed_vertices(scene, scene.instances[i], world_from_node, weights[i])});
  return deformed;
}

std::vector<Bounds> bounds_of_instances(const Scene& scene,
                                        const std::vector<glm::mat4>& world_from_node,
                                        const std::vector<DeformedInstance>& deformed) {
  std::vector<Bounds> boxes;
  auto next = deformed.begin();
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const MeshInstance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
    const glm::mat4 world = world_from_instance(instance, world_from_node);
    const bool is_next = next != deformed.end() && next->instance == i;
    const std::vector<Vertex>& vertices = is_next ? next++->vertices : mesh.vertices;
    Bounds& box = boxes.emplace_back(kAroundNothing);
    // Take only vertices that are drawn: files keep stray ones.
    for (const uint32_t index : mesh.indices) {
      const glm::vec3 point(world * glm::vec4(vertices[index].position, 1.0f));
      if (!is_finite(point)) continue;
      box.min = glm::min(box.min, point);
      box.max = glm::max(box.max, point);
    }
  }
  return boxes;
}

Bounds bounds_around(std::span<const Bounds> boxes) {
  Bounds all = kAroundNothing;
  for (const Bounds& box : boxes) {
    all.min = glm::min(all.min, box.min);
    all.max = glm::max(all.max, box.max);
  }
  return all.min.x <= all.max.x ? all : Bounds{};
}

Bounds bounds(const Scene& scene, const std::vector<glm::mat4>& world_from_node,
              const std::vector<DeformedInstance>& deformed) {
  return bounds_around(bounds_of_instances(scene, world_from_node, deformed));
}

Bounds bounds_at(const Scene& scene, float time_s) {
  const std::vector<glm::mat4> posed = pose(scene, time_s);
  return bounds(scene, posed, deformed_instances(scene, posed, time_s));
}

Scene with_deformed_meshes(Scene scene, float time_s) {
  auto deformed = deformed_instances(scene, pose(scene, time_s), time_s);
  for (DeformedInstance& shaped : deformed) {
    MeshInstance& instance = scene.instances[shaped.instance];
    const Mesh& source = scene.meshes[static_cast<size_t>(instance.mesh)];
    Mesh mesh{source.name, std::move(shaped.vertices), source.indices, source.primitives, {}, {}};
    instance.mesh = static_cast<int32_t>(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
    if (instance.skin != kNone) {
      instance.node = static_cast<int32_t>(scene.nodes.size());
      scene.nodes.emplace_back();
    }
    instance.skin = kNone;
    instance.morph_weights.clear();
  }
  return scene;
}

}  // namespace lueur
