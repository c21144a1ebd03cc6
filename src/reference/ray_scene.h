// SPDX-License-Identifier: MIT
// All of Embree that the reference uses: rays against the posed triangles of a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lueur/result.h"
#include "scene/scene.h"

namespace lueur::reference {

// The triangles of one primitive of one mesh instance, in world space.
struct Part {
  int32_t mesh = 0;
  int32_t material = 0;
  uint32_t first_index = 0;  // into the mesh's indices
  uint32_t triangle_count = 0;
  uint32_t instance = 0;  // index into Scene::instances
  bool mirrored = false;  // its transform turns the winding around
};

struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f};  // any length but 0; distances count in it
};

struct Hit {
  uint32_t part = 0;
  uint32_t triangle = 0;  // within the part
  float u = 0;            // barycentric coordinates of the second and third corner
  float v = 0;
  float distance = 0;
  glm::vec3 normal{0.0f};  // unit, of the triangle, towards the side its winding calls front
};

class RayScene {
 public:
  // `scene` must outlive this. Fails with ErrorKind::memory when its triangles do not fit.
  static Result<RayScene> create(const Scene& scene, const std::vector<glm::mat4>& world_from_node);
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  ~RayScene();

  // Holes of alpha-masked materials let every ray through. The camera's rays also pass the back
  // faces of one-sided materials; nothing else does.
  std::optional<Hit> nearest(const Ray& ray) const;
  std::optional<Hit> nearest_for_camera(const Ray& ray) const;
  // Whether anything lies nearer than `distance`, in lengths of the direction.
  bool is_blocked(const Ray& ray, float distance) const;
  bool is_blocked_for_camera(const Ray& ray, float distance) const;

  // Whether an alpha mask has a hole at these barycentric coordinates.
  bool is_hole(uint32_t part, uint32_t triangle, float u, float v) const;

  const std::vector<Part>& parts() const;
  // World positions of a triangle's corners.
  struct Corners {
    glm::vec3 a, b, c;
  };
  Corners corners(uint32_t part, uint32_t triangle) const;
  const Scene& scene() const;

 private:
  struct State;
  explicit RayScene(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace lueur::reference
