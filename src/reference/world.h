// SPDX-License-Identifier: MIT
// A posed scene as light meets it: surfaces with their materials, and what shines.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "reference/bsdf.h"
#include "reference/ray_scene.h"
#include "reference/texture.h"
#include "scene/placed_light.h"

namespace lueur::reference {

// Where on a material's textures a point lies.
struct TexturePlace {
  struct Coordinates {
    glm::vec2 uv{0.0f}, uv_2{0.0f};
  };
  Coordinates at;
  // A pixel's steps to the right and down; none: the finest level is read.
  std::optional<std::pair<Coordinates, Coordinates>> pixel_steps;
};

// The point that a ray met, as far as further rays need it. What it looks like is found on demand,
// as most points that a path meets are in the dark.
struct Touch {
  glm::vec3 position{0.0f};
  glm::vec3 geometric_normal{0.0f};  // unit, on the ray's side
  uint32_t part = 0;
  uint32_t triangle = 0;  // within the part
  float u = 0;            // barycentric coordinates of the second and third corner
  float v = 0;
  bool is_front = true;  // the side that the ray met
};

// The same with its normal: unit, interpolated and normal mapped, on the ray's side, but that it,
// as the rasterizer's, may lean a little beyond.
struct Surface : Touch {
  glm::vec3 normal{0.0f};
  TexturePlace place;
  glm::vec3 color{1.0f};  // of the vertices, interpolated
};

class World {
 public:
  // `scene` must outlive this. Where skins or morph targets shape it, this holds a copy of it as it
  // is at `time_s`.
  static Result<World> create(const Scene& scene, float time_s);

  const RayScene& rays() const { return rays_; }
  const Scene& scene() const { return rays_.scene(); }
  const std::vector<glm::mat4>& world_from_node() const { return world_from_node_; }
  const std::vector<PlacedLight>& punctual_lights() const { return punctual_lights_; }

  // What `ray` met.
  Touch touch(const Ray& ray, const Hit& hit) const;
  // Its textures are read at their finest level.
  Surface surface(const Touch& touch) const;
  // Its textures are filtered for a pixel whose neighbours' rays have the same origin and
  // directions `step_x` and `step_y` further on.
  Surface surface(const Ray& ray, const Hit& hit, const glm::vec3& step_x,
                  const glm::vec3& step_y) const;
  // The lobes of a surface towards `to_eye`, a unit vector; `least_diffuse_share` as Bsdf takes it.
  Bsdf bsdf(const Surface& surface, const glm::vec3& to_eye, float least_diffuse_share) const;
  glm::vec3 diffuse_albedo_of(const Surface& surface) const;
  // Whether camera rays meet this side of it: not the backs of one-sided materials.
  bool shows_to_camera(const Touch& touch) const {
    return touch.is_front || material_of(touch.part).double_sided;
  }

  // Emitted radiance, black in holes; of a surface, by its place on the texture; and the mean of a
  // part's material over its texture.
  glm::vec3 emission_at(uint32_t part, uint32_t triangle, float u, float v) const;
  glm::vec3 emission_of(const Surface& surface) const;
  glm::vec3 mean_emission(uint32_t part) const;

  // The origin for a ray that leaves the surface into the half space of `direction`: far enough off
  // not to meet its own triangle by rounding.
  static glm::vec3 origin(const Touch& touch, const glm::vec3& direction);

 private:
  struct MaterialTextures {
    std::optional<TextureSampler> base_color, metallic_roughness, normal, emission;
  };
  World(RayScene rays, std::vector<glm::mat4> world_from_node);
  static Result<World> create_rigid(const Scene& scene, float time_s);
  const Material& material_of(uint32_t part) const;
  struct TriangleVertices {
    const Vertex &a, &b, &c;
  };
  TriangleVertices vertices_of(const Touch& touch) const;
  Surface surface_at(const Touch& touch, const TriangleVertices& vertices,
                     const TexturePlace& place) const;
  glm::vec3 normal_of(const Surface& surface, const TriangleVertices& vertices) const;
  const MaterialTextures& textures_of(uint32_t part) const;
  static TexturePlace::Coordinates coordinates(const TriangleVertices& t, float u, float v);
  // The base colour as it looks, and what of it reflects light: nothing where it is unlit.
  glm::vec3 shown_color_of(const Surface& surface) const;
  glm::vec3 base_color_of(const Surface& surface) const;
  // x metallic, y perceptual roughness
  glm::vec2 metallic_roughness_of(const Surface& surface) const;

  std::unique_ptr<Scene> deformed_;  // what rays_ points to, if it is ours
  RayScene rays_;
  std::vector<glm::mat4> world_from_node_;
  std::vector<glm::mat3> normal_from_object_;  // inverse transpose, by instance
  std::vector<MaterialTextures> textures_;     // by material
  std::vector<PlacedLight> punctual_lights_;
};

}  // namespace lueur::reference
