// SPDX-License-Identifier: MIT
// Nearest hits of rays with a posed scene, on the CPU: enough to find out where in it one can
// stand.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace lueur {

class TriangleTree {
 public:
  struct Hit {
    float distance = 0.0f;  // in lengths of the direction
    bool front = false;     // the ray came from the side the triangle's normal points to
    bool double_sided = false;
  };

  // Every triangle drawn, in world space; every n-th one of scenes beyond some millions.
  TriangleTree(const Scene& scene, const std::vector<glm::mat4>& world_from_node);

  std::optional<Hit> trace(const glm::vec3& origin, const glm::vec3& direction) const;
  // Whether anything lies within `max_distance` lengths of the direction.
  bool is_blocked(const glm::vec3& origin, const glm::vec3& direction, float max_distance) const;

 private:
  struct Triangle {
    glm::vec3 corner;
    glm::vec3 edge_1;
    glm::vec3 edge_2;
    bool double_sided = false;
  };
  // A leaf holds triangles; an inner node's first child follows it.
  struct Branch {
    Bounds box;
    uint32_t first = 0;
    uint32_t count = 0;  // 0: inner node
    uint32_t second_child = 0;
  };

  void collect(const Scene& scene, const std::vector<glm::mat4>& world_from_node);
  void build();

  std::vector<Triangle> triangles_;
  std::vector<Branch> branches_;
};

}  // namespace lueur
