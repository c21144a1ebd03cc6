// SPDX-License-Identifier: MIT
#include "reference/world.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "scene/deform.h"
#include "shading/brdf.h"

namespace lueur::reference {
namespace {

std::optional<TextureSampler> sampler(const Scene& scene, const TextureUse& use,
                                      TextureSampler::Encoding encoding) {
  if (!use.is_used()) return std::nullopt;
  return TextureSampler(scene.textures[static_cast<size_t>(use.texture)], encoding);
}

// How far the barycentric coordinates (u, v) move with a ray's step, on the triangle's plane: the
// ray through origin + t (direction + step) meets it at another point.
glm::vec2 barycentric_step(const RayScene::Corners& t, const Ray& ray, float distance,
                           const glm::vec3& step) {
  const glm::vec3 e1 = t.b - t.a, e2 = t.c - t.a;
  const glm::vec3 n = glm::cross(e1, e2);
  const glm::vec3 direction = ray.direction + step;
  const glm::vec3 here = ray.origin + distance * ray.direction;
  const float along = glm::dot(n, direction);
  const glm::vec3 there = ray.origin + glm::dot(n, here - ray.origin) / along * direction;
  const glm::vec3 moved = there - here;
  const float area2 = glm::dot(n, n);
  return {glm::dot(glm::cross(moved, e2), n) / area2, glm::dot(glm::cross(e1, moved), n) / area2};
}

glm::vec4 look_up(const TextureSampler& texture, const TextureUse& use, const TexturePlace& place) {
  const glm::vec2 at = texture_place(use, place.at.uv, place.at.uv_2);
  if (!place.pixel_steps) return texture.finest(at);
  // A step is a difference of places: the offset drops out.
  const auto moved = [&](const TexturePlace::Coordinates& step) {
    return glm::mat2(use.transform) * (use.uv_set == 0 ? step.uv : step.uv_2);
  };
  return texture.filtered(at, moved(place.pixel_steps->first), moved(place.pixel_steps->second));
}

}  // namespace

World::World(RayScene rays, std::vector<glm::mat4> world_from_node)
    : rays_(std::move(rays)), world_from_node_(std::move(world_from_node)) {}

Result<World> World::create(const Scene& scene, float time_s) {
  const auto deforms = [&](const MeshInstance& instance) { return is_deformed(scene, instance); };
  if (std::none_of(scene.instances.begin(), scene.instances.end(), deforms))
    return create_rigid(scene, time_s);
  auto deformed = std::make_unique<Scene>(with_deformed_meshes(scene, time_s));
  LUEUR_TRY(world, create_rigid(*deformed, time_s));
  world.deformed_ = std::move(deformed);
  return std::move(world);
}

Result<World> World::create_rigid(const Scene& scene, float time_s) {
  std::vector<glm::mat4> posed = pose(scene, time_s);
  LUEUR_TRY(rays, RayScene::create(scene, posed));
  World world(std::move(rays), std::move(posed));
  for (const MeshInstance& instance : scene.instances) {
    const glm::mat3 linear(world.world_from_node_[static_cast<size_t>(instance.node)]);
    // As in the renderer, a transform that flattens leaves normals as they are.
    world.normal_from_object_.push_back(std::abs(glm::determinant(linear)) > 1e-30f
                                            ? glm::transpose(glm::inverse(linear))
                                            : glm::mat3(1.0f));
  }
  using enum TextureSampler::Encoding;
  for (const Material& m : scene.materials)
    world.textures_.push_back({sampler(scene, m.base_color_texture, srgb),
                               sampler(scene, m.metallic_roughness_texture, linear),
                               sampler(scene, m.normal_texture, linear),
                               sampler(scene, m.emission_texture, srgb)});
  for (const Light& light : scene.lights)
    world.punctual_lights_.push_back(
        place(light, world.world_from_node_[static_cast<size_t>(light.node)]));
  return world;
}

const Material& World::material_of(uint32_t part) const {
  return scene().materials[static_cast<size_t>(rays_.parts()[part].material)];
}

const World::MaterialTextures& World::textures_of(uint32_t part) const {
  return textures_[static_cast<size_t>(rays_.parts()[part].material)];
}

Touch World::touch(const Ray& ray, const Hit& hit) const {
  const RayScene::Corners corners = rays_.corners(hit.part, hit.triangle);
  const float w = 1.0f - hit.u - hit.v;
  const bool is_front = glm::dot(hit.normal, ray.direction) < 0.0f;
  return {.position = w * corners.a + hit.u * corners.b + hit.v * corners.c,
          .geometric_normal = is_front ? hit.normal : -hit.normal,
          .part = hit.part,
          .triangle = hit.triangle,
          .u = hit.u,
          .v = hit.v,
          .is_front = is_front};
}

World::TriangleVertices World::vertices_of(const Touch& touch) const {
  const Part& part = rays_.parts()[touch.part];
  const Mesh& mesh = scene().meshes[static_cast<size_t>(part.mesh)];
  const uint32_t* index = &mesh.indices[part.first_index + 3 * size_t{touch.triangle}];
  return {mesh.vertices[index[0]], mesh.vertices[index[1]], mesh.vertices[index[2]]};
}

TexturePlace::Coordinates World::coordinates(const TriangleVertices& t, float u, float v) {
  const float w = 1.0f - u - v;
  return {w * t.a.uv + u * t.b.uv + v * t.c.uv, w * t.a.uv_2 + u * t.b.uv_2 + v * t.c.uv_2};
}

Surface World::surface_at(const Touch& touch, const TriangleVertices& t,
                          const TexturePlace& place) const {
  const float w = 1.0f - touch.u - touch.v;
  const glm::vec4 color = w * color_of(t.a) + touch.u * color_of(t.b) + touch.v * color_of(t.c);
  Surface s{touch, {}, place, glm::vec3(color)};
  s.normal = normal_of(s, t);
  return s;
}

Surface World::surface(const Touch& touch) const {
  const TriangleVertices t = vertices_of(touch);
  return surface_at(touch, t, {coordinates(t, touch.u, touch.v), {}});
}

Surface World::surface(const Ray& ray, const Hit& hit, const glm::vec3& step_x,
                       const glm::vec3& step_y) const {
  const Touch met = touch(ray, hit);
  const TriangleVertices t = vertices_of(met);
  const RayScene::Corners corners = rays_.corners(hit.part, hit.triangle);
  const auto moved = [&](const glm::vec3& step) -> TexturePlace::Coordinates {
    const glm::vec2 by = barycentric_step(corners, ray, hit.distance, step);
    return {by.x * (t.b.uv - t.a.uv) + by.y * (t.c.uv - t.a.uv),
            by.x * (t.b.uv_2 - t.a.uv_2) + by.y * (t.c.uv_2 - t.a.uv_2)};
  };
  return surface_at(met, t,
                    {coordinates(t, met.u, met.v), std::pair(moved(step_x), moved(step_y))});
}

// Interpolates and maps the normal as g_buffer.frag does.
glm::vec3 World::normal_of(const Surface& s, const TriangleVertices& t) const {
  const Part& part = rays_.parts()[s.part];
  const float w = 1.0f - s.u - s.v;
  glm::vec3 n =
      normal_from_object_[part.instance] * (w * t.a.normal + s.u * t.b.normal + s.v * t.c.normal);
  const glm::vec3 front_normal = s.is_front ? s.geometric_normal : -s.geometric_normal;
  n = glm::dot(n, n) > 0.0f ? glm::normalize(n) : front_normal;
  if (const auto& texture = textures_of(s.part).normal) {
    const glm::mat3 linear(
        world_from_node_[static_cast<size_t>(scene().instances[part.instance].node)]);
    const glm::vec3 along =
        linear * glm::vec3(w * t.a.tangent + s.u * t.b.tangent + s.v * t.c.tangent);
    const glm::vec3 tangent = glm::normalize(along - n * glm::dot(n, along));
    const glm::vec3 bitangent = glm::cross(n, tangent) * t.a.tangent.w;
    const float scale = material_of(s.part).normal_scale;
    const glm::vec3 mapped =
        glm::vec3(look_up(*texture, material_of(s.part).normal_texture, s.place)) * 2.0f - 1.0f;
    const glm::vec3 perturbed =
        tangent * (scale * mapped.x) + bitangent * (scale * mapped.y) + n * mapped.z;
    if (glm::dot(perturbed, perturbed) > 1e-8f) n = glm::normalize(perturbed);
  }
  return s.is_front ? n : -n;
}

glm::vec3 World::shown_color_of(const Surface& s) const {
  const MaterialTextures& textures = textures_of(s.part);
  const Material& material = material_of(s.part);
  const glm::vec3 factor = glm::vec3(material.base_color) * s.color;
  if (!textures.base_color) return factor;
  return factor * glm::vec3(look_up(*textures.base_color, material.base_color_texture, s.place));
}

glm::vec3 World::base_color_of(const Surface& s) const {
  return material_of(s.part).unlit ? glm::vec3(0.0f) : shown_color_of(s);
}

glm::vec2 World::metallic_roughness_of(const Surface& s) const {
  const MaterialTextures& textures = textures_of(s.part);
  const Material& material = material_of(s.part);
  if (material.unlit) return glm::vec2(0.0f, 1.0f);
  const glm::vec2 factor(material.metallic, material.roughness);
  if (!textures.metallic_roughness) return factor;
  const glm::vec4 texel =
      look_up(*textures.metallic_roughness, material.metallic_roughness_texture, s.place);
  return factor * glm::vec2(texel.b, texel.g);
}

glm::vec3 World::diffuse_albedo_of(const Surface& s) const {
  return diffuse_albedo(base_color_of(s), metallic_roughness_of(s).x);
}

Bsdf World::bsdf(const Surface& s, const glm::vec3& to_eye, float least_diffuse_share) const {
  const Material& material = material_of(s.part);
  const glm::vec3 base_color = base_color_of(s);
  const glm::vec2 mr = metallic_roughness_of(s);
  const float specular = material.unlit ? 0.0f : material.specular;
  return {{.normal = s.normal,
           .to_eye = to_eye,
           .diffuse_albedo = diffuse_albedo(base_color, mr.x),
           .specular_f0 = specular_f0(base_color, mr.x, specular),
           .specular_f90 = specular_f90(mr.x, specular),
           .roughness = mr.y,
           .phong = material.phong},
          least_diffuse_share};
}

glm::vec3 World::mean_emission(uint32_t part) const {
  const Material& material = material_of(part);
  const MaterialTextures& textures = textures_of(part);
  const auto& texture = material.unlit ? textures.base_color : textures.emission;
  return (material.unlit ? glm::vec3(material.base_color) : material.emission) *
         (texture ? glm::vec3(texture->mean()) : glm::vec3(1.0f));
}

glm::vec3 World::emission_at(uint32_t part, uint32_t triangle, float u, float v) const {
  const Material& material = material_of(part);
  if (!material.unlit && material.emission == glm::vec3(0.0f)) return material.emission;
  if (rays_.is_hole(part, triangle, u, v)) return glm::vec3(0.0f);
  const Touch touch{.part = part, .triangle = triangle, .u = u, .v = v};
  const TriangleVertices t = vertices_of(touch);
  const float w = 1.0f - u - v;
  const glm::vec4 color = w * color_of(t.a) + u * color_of(t.b) + v * color_of(t.c);
  return emission_of(Surface{touch, {}, {coordinates(t, u, v), {}}, glm::vec3(color)});
}

glm::vec3 World::emission_of(const Surface& s) const {
  const Material& material = material_of(s.part);
  if (material.unlit) return shown_color_of(s);
  const auto& texture = textures_of(s.part).emission;
  if (!texture) return material.emission;
  return material.emission * glm::vec3(look_up(*texture, material.emission_texture, s.place));
}

glm::vec3 World::origin(const Touch& touch, const glm::vec3& direction) {
  // A position is off by some roundings of its largest coordinate; 2^-17 is 64 of them.
  const glm::vec3 reach = glm::abs(touch.position);
  const float step = 0x1p-17f * std::max({reach.x, reach.y, reach.z, 0x1p-7f});
  const float side = glm::dot(direction, touch.geometric_normal) < 0.0f ? -step : step;
  return touch.position + side * touch.geometric_normal;
}

}  // namespace lueur::reference
