// SPDX-License-Identifier: MIT
#include "scene/triangle_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace lueur {
namespace {

using glm::vec3;

constexpr uint64_t kMaxTriangles = 2'000'000;
constexpr uint32_t kLeafTriangles = 4;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Slab test: how far along the ray the box begins, infinity if it is missed or beyond `limit`.
float entry(const Bounds& box, const vec3& origin, const vec3& inverse_direction, float limit) {
  const vec3 a = (box.min - origin) * inverse_direction;
  const vec3 b = (box.max - origin) * inverse_direction;
  float enter = 0.0f;
  float leave = limit;
  for (int axis = 0; axis < 3; ++axis) {
    // NaN (a ray within a slab's plane) comes second in each comparison and changes nothing.
    enter = std::max(enter, std::min(a[axis], b[axis]));
    leave = std::min(leave, std::max(a[axis], b[axis]));
  }
  return enter <= leave * (1.0f + 1e-6f) ? enter : kInfinity;
}

}  // namespace

TriangleTree::TriangleTree(const Scene& scene, const std::vector<glm::mat4>& world_from_node) {
  collect(scene, world_from_node);
  build();
}

void TriangleTree::collect(const Scene& scene, const std::vector<glm::mat4>& world_from_node) {
  const uint64_t stride = triangle_count(scene) / kMaxTriangles + 1;
  uint64_t number = 0;
  for (const MeshInstance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
    const glm::mat4& world = world_from_node[static_cast<size_t>(instance.node)];
    const bool mirrored = glm::determinant(glm::mat3(world)) < 0.0f;
    for (const Primitive& primitive : mesh.primitives) {
      const bool double_sided =
          scene.materials[static_cast<size_t>(primitive.material)].double_sided;
      for (uint32_t i = 0; i + 2 < primitive.index_count; i += 3) {
        if (number++ % stride != 0) continue;
        std::array<vec3, 3> corners;
        for (uint32_t c = 0; c < 3; ++c) {
          const Vertex& vertex = mesh.vertices[mesh.indices[primitive.first_index + i + c]];
          corners[c] = vec3(world * glm::vec4(vertex.position, 1.0f));
        }
        // A mirroring transform turns the winding around.
        if (mirrored) std::swap(corners[1], corners[2]);
        triangles_.push_back(
            {corners[0], corners[1] - corners[0], corners[2] - corners[0], double_sided});
      }
    }
  }
}

void TriangleTree::build() {
  struct Job {
    uint32_t first, count;
    uint32_t parent;  // whose second child this is
    bool is_second;
  };
  if (triangles_.empty()) return;
  std::vector<Job> jobs{{0, static_cast<uint32_t>(triangles_.size()), 0, false}};
  while (!jobs.empty()) {
    const Job job = jobs.back();
    jobs.pop_back();
    const uint32_t self = static_cast<uint32_t>(branches_.size());
    if (job.is_second) branches_[job.parent].second_child = self;
    Branch branch{{vec3(kInfinity), vec3(-kInfinity)}, job.first, job.count, 0};
    for (uint32_t i = job.first; i < job.first + job.count; ++i) {
      const Triangle& t = triangles_[i];
      for (const vec3& p : {t.corner, t.corner + t.edge_1, t.corner + t.edge_2}) {
        branch.box.min = glm::min(branch.box.min, p);
        branch.box.max = glm::max(branch.box.max, p);
      }
    }
    if (job.count > kLeafTriangles) {
      // Halve the triangles along the box's longest axis: the tree is as deep as their logarithm.
      const vec3 size = branch.box.max - branch.box.min;
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      const uint32_t half = job.count / 2;
      const auto first = triangles_.begin() + job.first;
      std::nth_element(first, first + half, first + job.count,
                       [axis](const Triangle& a, const Triangle& b) {
                         const auto centre = [axis](const Triangle& t) {
                           return 3.0f * t.corner[axis] + t.edge_1[axis] + t.edge_2[axis];
                         };
                         return centre(a) < centre(b);
                       });
      branch.count = 0;
      // The first child is taken next, so that it follows its parent.
      jobs.push_back({job.first + half, job.count - half, self, true});
      jobs.push_back({job.first, half, self, false});
    }
    branches_.push_back(branch);
  }
}

std::optional<TriangleTree::Hit> TriangleTree::trace(const vec3& origin,
                                                     const vec3& direction) const {
  if (branches_.empty()) return std::nullopt;
  const vec3 inverse = 1.0f / direction;
  // Halving makes the tree at most 32 levels deep; each leaves one branch waiting.
  struct Waiting {
    uint32_t branch;
    float entry;
  };
  std::array<Waiting, 64> stack;
  size_t depth = 0;
  stack[depth++] = {0, 0.0f};
  Hit nearest{kInfinity, false, false};
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (next.entry >= nearest.distance) continue;
    const Branch& branch = branches_[next.branch];
    if (branch.count == 0) {
      // Take the nearer child first: its hits spare the other.
      Waiting near{next.branch + 1, 0.0f}, far{branch.second_child, 0.0f};
      near.entry = entry(branches_[near.branch].box, origin, inverse, nearest.distance);
      far.entry = entry(branches_[far.branch].box, origin, inverse, nearest.distance);
      if (near.entry > far.entry) std::swap(near, far);
      if (far.entry < kInfinity) stack[depth++] = far;
      if (near.entry < kInfinity) stack[depth++] = near;
      continue;
    }
    // Möller and Trumbore's test, from both sides.
    for (uint32_t i = branch.first; i < branch.first + branch.count; ++i) {
      const Triangle& t = triangles_[i];
      const vec3 p = glm::cross(direction, t.edge_2);
      const float determinant = glm::dot(t.edge_1, p);
      if (determinant == 0.0f) continue;
      const vec3 s = origin - t.corner;
      const float u = glm::dot(s, p) / determinant;
      const vec3 q = glm::cross(s, t.edge_1);
      const float v = glm::dot(direction, q) / determinant;
      const float distance = glm::dot(t.edge_2, q) / determinant;
      if (u >= 0.0f && v >= 0.0f && u + v <= 1.0f && distance > 0.0f && distance < nearest.distance)
        nearest = {distance, determinant > 0.0f, t.double_sided};
    }
  }
  if (nearest.distance == kInfinity) return std::nullopt;
  return nearest;
}

bool TriangleTree::is_blocked(const vec3& origin, const vec3& direction, float max_distance) const {
  const std::optional<Hit> hit = trace(origin, direction);
  return hit && hit->distance < max_distance;
}

}  // namespace lueur
