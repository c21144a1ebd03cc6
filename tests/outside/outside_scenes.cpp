// SPDX-License-Identifier: MIT
#include "outside/outside_scenes.h"

#include <cmath>

#include "base/check.h"
#include "scene/builtin/builtin.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur {
namespace {

Scene diffuse_cornell() {
  auto scene = make_builtin_scene("cornell");
  LUEUR_CHECK(scene.ok());
  for (Material& material : scene->materials) material.specular = 0.0f;
  return std::move(*scene);
}

int32_t add_diffuse(Scene& scene, const char* name, glm::vec3 albedo) {
  const int32_t material = builtin::add_material(scene, name, albedo, 1.0f);
  scene.materials[material].specular = 0.0f;
  return material;
}

void add_box(Scene& scene, const char* name, int32_t material, glm::vec3 min, glm::vec3 max) {
  builtin::MeshBuilder builder;
  builder.set_material(material, 2.0f);
  builtin::add_box(builder, min, max, builtin::Tessellation{1.0f});
  builtin::add_mesh(scene, builder.finish(name));
}

void add_ball(Scene& scene, const char* name, int32_t material, glm::vec3 center, float radius_m) {
  builtin::MeshBuilder builder;
  builder.set_material(material);
  builtin::add_sphere(builder, center, radius_m, 128);
  builtin::add_mesh(scene, builder.finish(name));
}

void add_light(Scene& scene, Light light, glm::vec3 place, glm::vec3 direction) {
  light.node = builtin::add_node(scene, light.name, place, builtin::look_along(direction));
  scene.lights.push_back(light);
}

// Four colours, one texel each: between texels renderers decode sRGB at different times.
Texture make_chequers() {
  Texture texture = builtin::make_color_texture("chequers", 2, [](glm::vec2 uv) {
    const int cell = (uv.x < 0.5f ? 0 : 1) + (uv.y < 0.5f ? 0 : 2);
    constexpr glm::vec3 kColors[] = {
        {0.8f, 0.75f, 0.7f}, {0.2f, 0.3f, 0.6f}, {0.6f, 0.25f, 0.1f}, {0.8f, 0.75f, 0.7f}};
    return kColors[cell];
  });
  texture.nearest = true;
  return texture;
}

}  // namespace

Scene cornell_lit_by_spot() {
  Scene scene = diffuse_cornell();
  for (Material& material : scene.materials) material.emission = glm::vec3(0.0f);
  return scene;
}

Scene cornell_lit_by_glow() {
  Scene scene = diffuse_cornell();
  // A light of nothing: a file without any would be given one.
  for (Light& light : scene.lights) light.intensity = 0.0f;
  return scene;
}

Scene floor_below(const Light& light, glm::vec3 place, glm::vec3 direction) {
  Scene scene;
  scene.name = "floor";
  const int32_t grey = add_diffuse(scene, "grey", glm::vec3(kFloorAlbedo));
  add_box(scene, "floor", grey, {-5, -0.2f, -5}, {5, 0, 5});
  constexpr float kEyeHeight = 10.0f;  // m
  builtin::add_camera(scene, "above", {0, kEyeHeight, 0}, glm::vec3(0.0f),
                      2.0f * std::atan(0.5f * kFloorHeight / kEyeHeight));
  add_light(scene, light, place, direction);
  return scene;
}

Scene still_life() {
  Scene scene;
  scene.name = "still life";
  const int32_t floor = add_diffuse(scene, "floor", glm::vec3(1.0f));
  scene.materials[floor].base_color_texture = 0;
  scene.textures.push_back(make_chequers());
  const int32_t wall = add_diffuse(scene, "wall", {0.7f, 0.7f, 0.65f});
  const int32_t red = add_diffuse(scene, "red", {0.75f, 0.12f, 0.08f});
  const int32_t green = add_diffuse(scene, "green", {0.15f, 0.55f, 0.2f});
  const int32_t metal = builtin::add_material(scene, "metal", glm::vec3(1.0f), 0.4f);
  scene.materials[metal].metallic = 1.0f;

  add_box(scene, "floor", floor, {-3, -0.2f, -3}, {3, 0, 3});
  add_box(scene, "back wall", wall, {-3, -0.2f, -3.2f}, {3, 3, -3});
  add_box(scene, "left wall", red, {-3.2f, -0.2f, -3.2f}, {-3, 3, 3});
  add_box(scene, "box", wall, {0.9f, 0, -1.6f}, {1.9f, 1.6f, -0.6f});
  add_ball(scene, "metal ball", metal, {-0.9f, 0.8f, -1.0f}, 0.8f);
  add_ball(scene, "green ball", green, {0.5f, 0.5f, 0.6f}, 0.5f);

  builtin::add_camera(scene, "front", {1.2f, 2.2f, 6.0f}, {-0.3f, 0.8f, -0.6f}, 0.75f);
  add_light(scene, {.name = "sun", .kind = LightKind::directional, .intensity = 40.0f},
            glm::vec3(0.0f), {-0.5f, -1.0f, -0.6f});
  add_light(scene, {.name = "lamp", .color = {1.0f, 0.8f, 0.5f}, .intensity = 100.0f},
            {0.8f, 2.4f, 1.5f}, {0, -1, 0});
  return scene;
}

}  // namespace lueur
