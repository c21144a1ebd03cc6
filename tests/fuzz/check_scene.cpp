// SPDX-License-Identifier: MIT
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "base/check.h"
#include "fuzz_input.h"
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
}

}  // namespace

void check_scene(const Scene& scene) {
  LUEUR_CHECK(!scene.materials.empty());
  for (size_t i = 0; i < scene.nodes.size(); ++i)
    LUEUR_CHECK_OP(scene.nodes[i].parent, <, static_cast<int32_t>(i));
  for (const Mesh& mesh : scene.meshes) check_mesh(mesh, scene.materials.size());
  for (const MeshInstance& instance : scene.instances) {
    LUEUR_CHECK_OP(static_cast<size_t>(instance.mesh), <, scene.meshes.size());
    LUEUR_CHECK_OP(static_cast<size_t>(instance.node), <, scene.nodes.size());
  }
  for (const Texture& texture : scene.textures)
    LUEUR_CHECK_OP(texture.rgba.size(), ==, size_t{texture.width} * texture.height * 4);
  for (const glm::mat4& world : pose(scene, 0.0f))
    for (int i = 0; i < 16; ++i) LUEUR_CHECK(std::isfinite(glm::value_ptr(world)[i]));
}

void check_completed(const Scene& scene) {
  Scene completed = scene;
  complete(completed);
  LUEUR_CHECK(!completed.cameras.empty() && !completed.lights.empty());
}

}  // namespace lueur
