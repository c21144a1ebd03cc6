// SPDX-License-Identifier: MIT
#include "support/test_scene.h"

#include <cmath>

#include "scene/builtin/scene_builder.h"

namespace lueur {

Scene scene_seen_from(const glm::vec3& eye, const glm::vec3& target) {
  Scene scene;
  builtin::add_camera(scene, "camera", eye, target, 0.8f);
  builtin::add_material(scene, "white", glm::vec3(1.0f), 1.0f);
  return scene;
}

int32_t add_quad(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                 int32_t material) {
  const glm::vec3 normal = glm::normalize(glm::cross(u, v));
  const glm::vec4 tangent(glm::normalize(u), 1.0f);
  Mesh mesh;
  mesh.name = "quad";
  mesh.vertices = {{corner, normal, tangent, {0, 0}},
                   {corner + u, normal, tangent, {1, 0}},
                   {corner + u + v, normal, tangent, {1, 1}},
                   {corner + v, normal, tangent, {0, 1}}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.primitives = {{0, 6, material}};
  return builtin::add_mesh(scene, std::move(mesh));
}

int32_t add_floor(Scene& scene, float half_side, int32_t material) {
  return add_quad(scene, {-half_side, 0, half_side}, {2 * half_side, 0, 0}, {0, 0, -2 * half_side},
                  material);
}

Light& add_light(Scene& scene, LightKind kind, float intensity, const glm::vec3& position,
                 const glm::vec3& direction) {
  Light light;
  light.kind = kind;
  light.intensity = intensity;
  light.node = builtin::add_node(scene, "light", position, builtin::look_along(direction));
  scene.lights.push_back(light);
  return scene.lights.back();
}

std::vector<PixelRay> pixel_rays(const Camera& camera, const glm::dmat4& world_from_camera,
                                 uint32_t width, uint32_t height) {
  const double tan_v = std::tan(0.5 * static_cast<double>(camera.vertical_fov_rad));
  const double tan_h = tan_v * width / height;
  std::vector<PixelRay> list;
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const glm::dvec3 in_view((2.0 * (x + 0.5) / width - 1.0) * tan_h,
                               (1.0 - 2.0 * (y + 0.5) / height) * tan_v, -1.0);
      list.push_back({x, y, list.size(), glm::dvec3(world_from_camera[3]),
                      glm::dmat3(world_from_camera) * in_view});
    }
  }
  return list;
}

std::optional<glm::dvec3> meet_plane(const PixelRay& ray, const glm::dvec3& point,
                                     const glm::dvec3& normal) {
  const double t = glm::dot(point - ray.origin, normal) / glm::dot(ray.direction, normal);
  if (!(t > 0.0) || !std::isfinite(t)) return std::nullopt;
  return ray.origin + t * ray.direction;
}

}  // namespace lueur
