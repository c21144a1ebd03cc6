// SPDX-License-Identifier: MIT
// A graveyard under a full moon, after the one of Nalbach, Ritschel, Seidel 2015: much small relief
// that hides light from itself, and a wall of bricks that stand out by different amounts. The moon
// stands to the left and only grazes what the camera sees from the front; the rest lives from what
// ground, sky and candles give. Moon and candles are as bright as real ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <utility>

#include "scene/builtin/graveyard_parts.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

constexpr float kMoonLux = 0.25f, kStoneAlbedo = 0.4f;
constexpr glm::vec3 kMoonDirection{0.80f, -0.62f, -0.20f};
constexpr glm::vec3 kCandleColor{1.0f, 0.52f, 0.18f};
constexpr glm::vec3 kCryptPlace{-1.9f, 0, -8.4f};

// Night sky over a line of woods; brighter towards the horizon. Repeats sideways;
// v runs upwards, as on a sweep.
glm::vec3 sky_color(glm::vec2 uv) {
  const float height = uv.y;
  const float clouds = tiling_noise({uv.x, 2.0f * uv.y}, 4, 6, 151);
  glm::vec3 sky = glm::mix(glm::vec3(0.30f, 0.42f, 0.60f), glm::vec3(0.025f, 0.045f, 0.12f),
                           glm::smoothstep(0.10f, 0.75f, height));
  sky *= 0.55f + 0.9f * glm::smoothstep(0.35f, 0.75f, clouds);
  const float woods = 0.185f + 0.05f * tiling_noise({uv.x, 0.0f}, 6, 2, 152) +
                      0.03f * tiling_noise({uv.x, 0.0f}, 48, 3, 153);
  return glm::mix(glm::vec3(0.012f, 0.016f, 0.022f), sky,
                  glm::smoothstep(-0.004f, 0.004f, height - woods));
}

// Rows of letters cut into a slab.
Pattern inscription_pattern() {
  const auto cut = [](glm::vec2 uv) {
    const glm::vec2 cell = uv * glm::vec2(14, 7);
    const int row = int(cell.y), column = int(cell.x);
    const glm::vec2 p = cell - glm::floor(cell) - 0.5f;
    const float reach = 3.0f + 3.0f * hash_unit(0, uint32_t(row), 161);
    if (row == 0 || row == 6 || std::abs(float(column) + 0.5f - 7.0f) > reach) return 0.0f;
    const auto stroke = [&](uint32_t seed) {
      return hash_unit(uint32_t(column), uint32_t(row), seed) < 0.55f;
    };
    const float ink = 0.07f, x = 0.27f, y = 0.33f;
    if (std::abs(p.x) > x + ink || std::abs(p.y) > y + ink) return 0.0f;
    bool inside = std::abs(p.x + x) < ink;
    inside |= stroke(162) && std::abs(p.x - x) < ink;
    for (int bar = 0; bar < 3; ++bar)
      inside |= stroke(163 + uint32_t(bar)) && std::abs(p.y - y * float(bar - 1)) < ink;
    return inside ? 1.0f : 0.0f;
  };
  const Pattern stone = old_stone_pattern();
  return {[=](glm::vec2 uv) { return stone.albedo(uv) * (1.15f - 0.75f * cut(uv)); },
          [=](glm::vec2 uv) { return 0.4f * stone.height_m(uv) - 0.008f * cut(uv); }};
}

GraveyardMaterials add_materials(Scene& scene) {
  GraveyardMaterials m{};
  const auto patterned = [&](const char* name, float roughness, uint32_t size, float size_m,
                             const Pattern& pattern) {
    const int32_t material = add_material(scene, name, glm::vec3(1.0f), roughness);
    bind_pattern(scene, material, name, size, size_m, pattern);
    return material;
  };
  m.stone = patterned("old stone", 0.85f, 512, 1.4f, old_stone_pattern());
  m.granite = add_material(scene, "granite", {0.62f, 0.63f, 0.68f}, 0.55f);
  scene.materials[m.granite].base_color_texture = scene.materials[m.stone].base_color_texture;
  scene.materials[m.granite].normal_texture = scene.materials[m.stone].normal_texture;
  m.slab = patterned("inscription", 0.6f, 256, 0.6f, inscription_pattern());
  m.brick = patterned("brick", 0.9f, 256, 0.9f, clay_pattern());
  m.mortar = add_material(scene, "mortar", glm::vec3(0.30f, 0.28f, 0.25f));
  m.iron = add_material(scene, "iron", glm::vec3(0.10f, 0.095f, 0.09f), 0.45f);
  m.bark = patterned("bark", 0.9f, 256, 0.8f, bark_pattern());
  m.grass = add_material(scene, "grass", {0.10f, 0.15f, 0.05f}, 0.8f);
  m.earth = patterned("earth", 0.95f, 512, 2.2f, earth_pattern());
  m.feathers = add_material(scene, "feathers", {0.02f, 0.02f, 0.026f}, 0.35f);
  m.wax = add_material(scene, "wax", {0.75f, 0.68f, 0.52f}, 0.5f);
  m.flame = add_material(scene, "flame", glm::vec3(0.5f));
  scene.materials[m.flame].emission = kCandleColor * 2.0f;  // shows white; the light is apart
  m.sky = add_material(scene, "sky", glm::vec3(0.0f), 1.0f);
  Material& sky = scene.materials[m.sky];
  sky.specular = 0.0f;
  sky.emission = glm::vec3(0.022f);
  sky.emission_texture = int32_t(scene.textures.size());
  scene.textures.push_back(make_color_texture("sky", 512, sky_color));
  return m;
}

// Adds one mesh at many places.
struct Place {
  glm::vec3 translation;
  glm::quat rotation{1, 0, 0, 0};
};
template <class Add>
void add_everywhere(Scene& scene, const std::string& name, const std::vector<Place>& places,
                    Add&& add) {
  MeshBuilder builder;
  add(builder);
  scene.meshes.push_back(builder.finish(name));
  for (const Place& place : places)
    add_instance(scene, int32_t(scene.meshes.size()) - 1,
                 add_node(scene, name, place.translation, place.rotation));
}

glm::quat turned(float angle_rad) {
  return glm::angleAxis(angle_rad, glm::vec3(0, 1, 0));
}

// Graves in rows to both sides of the path, every stone a little out of true.
struct Grave {
  float x, z;
  Tombstone kind;
};
constexpr std::array<Grave, 29> kGraves{{
    {2.35f, 4.2f, Tombstone::round},        {-2.1f, 4.4f, Tombstone::broken},
    {-3.7f, 3.9f, Tombstone::pointed},      {4.1f, 3.5f, Tombstone::chest},
    {-1.75f, 2.2f, Tombstone::shouldered},  {-3.4f, 1.9f, Tombstone::ringed_cross},
    {-5.2f, 2.3f, Tombstone::round},        {1.55f, 1.7f, Tombstone::pointed},
    {2.95f, 1.4f, Tombstone::cross},        {4.8f, 1.0f, Tombstone::shouldered},
    {6.3f, 1.6f, Tombstone::round},         {-2.3f, -0.2f, Tombstone::round},
    {-3.9f, -0.5f, Tombstone::chest},       {-5.8f, 0.1f, Tombstone::pointed},
    {1.2f, -0.8f, Tombstone::broken},       {2.6f, -1.1f, Tombstone::ringed_cross},
    {4.1f, -1.0f, Tombstone::round},        {5.7f, -0.9f, Tombstone::obelisk},
    {-3.1f, -2.6f, Tombstone::shouldered},  {-4.7f, -2.9f, Tombstone::obelisk},
    {-6.5f, -2.3f, Tombstone::cross},       {0.6f, -3.2f, Tombstone::round},
    {2.1f, -3.4f, Tombstone::shouldered},   {3.6f, -3.2f, Tombstone::pointed},
    {5.1f, -3.5f, Tombstone::cross},        {6.9f, -2.9f, Tombstone::broken},
    {1.2f, -5.4f, Tombstone::cross},        {2.6f, -5.6f, Tombstone::round},
    {6.9f, -5.6f, Tombstone::ringed_cross},
}};

void add_graves(Scene& scene, const GraveyardMaterials& m) {
  constexpr const char* kNames[kTombstones] = {"round stone",  "pointed stone", "shouldered stone",
                                               "broken stone", "cross",         "ringed cross",
                                               "obelisk",      "chest tomb"};
  for (int kind = 0; kind < kTombstones; ++kind) {
    std::vector<Place> places;
    for (uint32_t k = 0; k < kGraves.size(); ++k) {
      const Grave& grave = kGraves[k];
      if (int(grave.kind) != kind) continue;
      const auto out_of_true = [&](uint32_t seed, float most) {
        return most * (2.0f * hash_unit(k, 0, seed) - 1.0f);
      };
      const float tilt = grave.kind == Tombstone::chest ? 0.03f : 0.13f;
      places.push_back(
          {{grave.x, ground_height(grave.x, grave.z), grave.z},
           glm::normalize(turned(out_of_true(171, 0.22f)) *
                          glm::angleAxis(out_of_true(172, tilt), glm::vec3(1, 0, 0)) *
                          glm::angleAxis(out_of_true(173, tilt), glm::vec3(0, 0, 1)))});
    }
    add_everywhere(scene, kNames[kind], places,
                   [&](MeshBuilder& builder) { add_tombstone(builder, m, Tombstone(kind)); });
  }
}

void add_enclosure(Scene& scene, const GraveyardMaterials& m) {
  add_everywhere(scene, "brick wall", {{{5.2f, ground_height(5.2f, -7.4f), -7.4f}}},
                 [&](MeshBuilder& builder) { add_brick_wall(builder, m); });

  // The fence goes on to the left of the crypt and comes forward at the side.
  std::vector<Place> panels, pillars;
  for (int k = 0; k < 3; ++k) {
    const float x = -10.6f + (kFencePanel + 0.4f) * float(k);
    panels.push_back({{x + 0.2f, ground_height(x + 1.0f, -7.6f), -7.6f}});
    pillars.push_back({{x, ground_height(x, -7.6f), -7.6f}});
  }
  for (int k = 0; k < 5; ++k) {
    const float z = -7.6f + (kFencePanel + 0.4f) * float(k + 1);
    panels.push_back({{-10.6f, ground_height(-10.6f, z - 1.0f), z - 0.2f}, turned(0.5f * kPi)});
    pillars.push_back({{-10.6f, ground_height(-10.6f, z), z}});
  }
  add_everywhere(scene, "fence", panels,
                 [&](MeshBuilder& builder) { add_fence_panel(builder, m); });
  add_everywhere(scene, "pillar", pillars,
                 [&](MeshBuilder& builder) { add_fence_pillar(builder, m); });
}

// Trees move with the wind, hardly to be seen.
void add_trees(Scene& scene, const GraveyardMaterials& m) {
  constexpr glm::vec3 kPlaces[3] = {{-6.9f, 0, -4.6f}, {7.9f, 0, -4.8f}, {-9.0f, 0, 3.2f}};
  for (uint32_t k = 0; k < 3; ++k) {
    if (k < 2) {
      MeshBuilder builder;
      add_tree(builder, m, 181 + 2 * k);
      scene.meshes.push_back(builder.finish(k == 0 ? "tree" : "second tree"));
    }
    const glm::vec3 p = kPlaces[k];
    const int32_t node = add_node(scene, "tree", {p.x, ground_height(p.x, p.z), p.z});
    add_instance(scene, int32_t(scene.meshes.size()) - (k == 2 ? 2 : 1), node);
    animate_rotation(scene, node, 40, [=](float phase) {
      const float sway = 0.008f * std::sin(2 * kPi * (phase + 0.3f * float(k)));
      return turned(2.1f * float(k)) * glm::angleAxis(sway, glm::vec3(0, 0, 1));
    });
  }
}

void add_grass(Scene& scene, const GraveyardMaterials& m) {
  MeshBuilder builder;
  uint32_t tuft = 0;
  const auto add_at = [&](float x, float z) {
    ++tuft;
    if (std::abs(x - path_center(z)) > 0.85f)
      add_grass_tuft(builder, m, {x, ground_height(x, z), z}, 1000 + tuft);
  };
  const auto offset = [&](uint32_t seed, float most) {
    return most * (2.0f * hash_unit(tuft, 0, seed) - 1.0f);
  };
  for (const Grave& grave : kGraves)
    for (int k = 0; k < 3; ++k)
      add_at(grave.x + offset(191, 0.7f), grave.z + 0.2f + offset(192, 0.4f));
  for (int k = 0; k < 36; ++k) add_at(offset(193, 6.5f), 1.0f + offset(194, 6.5f));
  add_mesh(scene, builder.finish("grass"));
}

void add_sky(Scene& scene, const GraveyardMaterials& m) {
  // A bent screen behind everything that the cameras see; the moon stands beside it.
  constexpr float kRadius = 24.0f, kThick = 0.2f, kBottom = -2.5f, kTop = 17.0f;
  constexpr float kRight = -0.1f, kLeft = 2.65f;  // angles from +x by way of -z
  constexpr int kCells = 48;
  MeshBuilder builder;
  builder.set_material(m.sky, kTop - kBottom);
  Profile screen({0, kTop}, Tessellation{100.0f});
  screen.line_to({0, kBottom})
      .line_to({kThick, kBottom})
      .line_to({kThick, kTop})
      .line_to({0, kTop});
  add_sweep(builder, screen, {0.5f * kThick, 0.5f * (kBottom + kTop)}, kCells, [](int k) {
    const float angle = kRight + (kLeft - kRight) * float(k) / float(kCells);
    const glm::vec3 out(std::cos(angle), 0, -std::sin(angle));
    return SweepFrame{kRadius * out, out, {0, 1, 0}};
  });
  Mesh mesh = builder.finish("sky");
  for (Vertex& v : mesh.vertices) v.uv.x *= 0.5f;  // clouds are wider than high
  add_mesh(scene, std::move(mesh));
}

Light candle_light(const char* name, int32_t node, float candela) {
  Light light;
  light.name = name;
  light.kind = LightKind::point;
  light.node = node;
  light.color = kCandleColor;
  light.intensity = candela;
  return light;
}

void add_lights(Scene& scene, const GraveyardMaterials& m) {
  Light moon;
  moon.name = "moon";
  moon.kind = LightKind::directional;
  moon.color = {0.62f, 0.76f, 1.0f};
  moon.intensity = kMoonLux;
  moon.node = add_node(scene, "moon", -20.0f * kMoonDirection);
  animate_rotation(scene, moon.node, 40, [](float phase) {
    return look_along(kMoonDirection + glm::vec3(0, 0, 0.12f * std::sin(2 * kPi * phase)));
  });
  scene.lights.push_back(moon);

  // The lantern swings on its hook.
  const glm::vec3 post{1.75f, ground_height(1.75f, 5.0f), 5.0f};
  add_everywhere(scene, "lantern post", {{post, turned(0.3f)}},
                 [&](MeshBuilder& builder) { add_lantern_post(builder, m); });
  MeshBuilder builder;
  add_lantern(builder, m);
  const int32_t lantern = add_mesh(scene, builder.finish("lantern"));
  scene.nodes[lantern].translation = post + turned(0.3f) * kHook;
  animate_rotation(scene, lantern, 60, [](float phase) {
    return turned(0.3f) * glm::angleAxis(0.10f * std::sin(6 * kPi * phase), glm::vec3(0, 0, 1)) *
           glm::angleAxis(0.16f * std::sin(4 * kPi * phase), glm::vec3(1, 0, 0));
  });
  const int32_t flame =
      add_node(scene, "lantern light", kLanternLight, look_along({-0.87f, -0.8f, -0.5f}), lantern);
  scene.lights.push_back(candle_light("lantern light", flame, 0.9f));

  // Two candles stand on the chest in the crypt; one light serves for both.
  std::vector<Place> candles;
  for (const float x : {-0.55f, 0.5f})
    candles.push_back({kCryptPlace + glm::vec3(x, 1.08f, -0.40f)});
  add_everywhere(scene, "candle", candles, [&](MeshBuilder& candle) { add_candle(candle, m); });
  const int32_t inside = add_node(scene, "crypt light", kCryptPlace + glm::vec3(0.1f, 1.75f, -0.3f),
                                  look_along({0.9f, -0.2f, -0.4f}));
  scene.lights.push_back(candle_light("crypt light", inside, 0.85f));
}

void add_cameras(Scene& scene) {
  const auto eye = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(0.55f + 0.55f * std::sin(angle), 1.72f + 0.12f * std::sin(2 * angle),
                     8.9f - 0.7f * (1.0f - std::cos(angle)));
  };
  const glm::vec3 target{-0.35f, 1.35f, -2.0f};
  const int32_t gate = add_camera(scene, "gate", eye(0), target, 0.80f);
  animate_camera(scene, gate, 40, eye, [=](float) { return target; });
  add_camera(scene, "wall", {3.3f, 1.35f, -4.3f}, {4.9f, 0.62f, -7.3f}, 0.85f);
  add_camera(scene, "lantern", {-0.4f, 1.25f, 6.6f}, {2.1f, 0.85f, 3.6f}, 0.75f);
}

}  // namespace

Scene make_graveyard() {
  Scene scene;
  scene.name = "graveyard";
  const GraveyardMaterials m = add_materials(scene);
  add_cameras(scene);
  const auto add_one = [&](const char* name, void (*add)(MeshBuilder&, const GraveyardMaterials&)) {
    MeshBuilder builder;
    add(builder, m);
    return add_mesh(scene, builder.finish(name));
  };
  add_one("ground", add_ground);
  add_one("path", add_path);
  scene.nodes[add_one("crypt", add_crypt)].translation = kCryptPlace;
  add_graves(scene, m);
  add_enclosure(scene, m);
  add_trees(scene, m);
  add_grass(scene, m);
  add_sky(scene, m);
  add_lights(scene, m);

  // A raven on the obelisk's neighbour looks about.
  const int32_t raven = add_one("raven", add_raven);
  scene.nodes[raven].translation = {-3.4f, ground_height(-3.4f, 1.9f) + 1.92f, 1.9f};
  animate_rotation(scene, raven, 40, [](float phase) {
    return turned(0.7f + 0.9f * std::sin(2 * kPi * phase) * std::abs(std::sin(2 * kPi * phase)));
  });
  scene.exposure_ev = exposure_for(kStoneAlbedo, kMoonLux);
  return scene;
}

}  // namespace lueur::builtin
