// SPDX-License-Identifier: MIT
// For the tests of the built-in scenes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/builtin/builtin.h"
#include "scene/scene.h"

namespace lueur {

inline Scene make_anew(const std::string& spec) {
  Result<Scene> scene = make_builtin_scene(spec);
  EXPECT_TRUE(scene.ok()) << scene.error().message;
  return scene.ok() ? std::move(*scene) : Scene{};
}

// Makes each scene once: sculpting takes a second.
inline const Scene& make(const std::string& spec) {
  static std::map<std::string, Scene> made;
  const auto found = made.find(spec);
  return found != made.end() ? found->second : made.emplace(spec, make_anew(spec)).first->second;
}

// The nearest hit of a ray with the scene, by looking at every triangle; infinity if none.
inline float ray_distance(const Scene& scene, const std::vector<glm::mat4>& world, glm::vec3 origin,
                          glm::vec3 direction) {
  float nearest = INFINITY;
  for (const MeshInstance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (size_t k = 0; k < mesh.indices.size(); k += 3) {
      glm::vec3 p[3];
      for (size_t c = 0; c < 3; ++c)
        p[c] = glm::vec3(world[instance.node] *
                         glm::vec4(mesh.vertices[mesh.indices[k + c]].position, 1));
      const glm::vec3 e1 = p[1] - p[0], e2 = p[2] - p[0], q = glm::cross(direction, e2);
      const float det = glm::dot(e1, q);
      if (std::abs(det) < 1e-12f) continue;
      const glm::vec3 s = origin - p[0], r = glm::cross(s, e1);
      const float u = glm::dot(s, q) / det, v = glm::dot(direction, r) / det;
      const float t = glm::dot(e2, r) / det;
      if (u >= 0 && v >= 0 && u + v <= 1 && t > 1e-4f) nearest = std::min(nearest, t);
    }
  }
  return nearest;
}

}  // namespace lueur
