// SPDX-License-Identifier: MIT
// A two-storey courtyard in the manner of the Sponza palace's: the sun falls steeply through the
// open roof on one side of the court; aisles and galleries live from what it throws back.
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"

namespace lueur::builtin {
namespace {

constexpr float kSunLux = 32'000.0f;  // a hazy day
constexpr glm::vec3 kSunDirection{2.8f, -9.5f, 3.3f};
constexpr float kStoneAlbedo = 0.62f;

// One mesh of the atrium and everywhere it stands.
struct Part {
  std::string name;
  std::function<void(MeshBuilder&, const Tessellation&)> add;
  struct Place {
    glm::vec3 translation{0.0f};
    float turn_rad = 0.0f;  // about y
  };
  std::vector<Place> places;
};

AtriumMaterials add_materials(Scene& scene) {
  AtriumMaterials m{};
  const auto patterned = [&](const char* name, float roughness, uint32_t size, float size_m,
                             const Pattern& pattern) {
    const int32_t material = add_material(scene, name, glm::vec3(1.0f), roughness);
    bind_pattern(scene, material, name, size, size_m, pattern);
    return material;
  };
  m.pavement = patterned("pavement", 0.55f, 512, 2.0f, pavement_pattern());
  m.masonry = patterned("masonry", 0.9f, 512, 2.0f, masonry_pattern());
  m.limestone = patterned("limestone", 0.75f, 256, 2.0f, limestone_pattern());
  m.wood = patterned("wood", 0.6f, 256, 1.0f, wood_pattern());

  // Plaster is limestone's clouds, warmer; the three cloths share one weave.
  m.plaster = add_material(scene, "plaster", {1.0f, 0.90f, 0.76f}, 0.95f);
  scene.materials[m.plaster].base_color_texture = scene.materials[m.limestone].base_color_texture;
  m.cloth[0] = patterned("red cloth", 0.95f, 256, 0.5f, cloth_pattern());
  scene.materials[m.cloth[0]].base_color = {0.72f, 0.035f, 0.03f, 1.0f};
  const glm::vec3 other_cloths[2] = {{0.06f, 0.42f, 0.07f}, {0.035f, 0.10f, 0.58f}};
  for (int k = 0; k < 2; ++k) {
    Material cloth = scene.materials[m.cloth[0]];
    cloth.name = k == 0 ? "green cloth" : "blue cloth";
    cloth.base_color = glm::vec4(other_cloths[k], 1.0f);
    m.cloth[k + 1] = int32_t(scene.materials.size());
    scene.materials.push_back(cloth);
  }
  m.terracotta = add_material(scene, "terracotta", {0.52f, 0.22f, 0.12f}, 0.85f);
  m.leaves = add_material(scene, "leaves", {0.10f, 0.24f, 0.05f}, 0.8f);
  m.water = add_material(scene, "water", {0.04f, 0.10f, 0.11f}, 0.08f);
  m.bronze = add_material(scene, "bronze", {0.55f, 0.38f, 0.20f}, 0.4f);
  scene.materials[m.bronze].metallic = 1.0f;
  return m;
}

// The places of the columns of one storey, on both sides.
std::vector<Part::Place> column_places(float y) {
  std::vector<Part::Place> places;
  for (const float z : {-kColumnZ, kColumnZ})
    for (int line = 1; line < kBays; ++line)
      places.push_back({{column_line(line), y, z}, z > 0 ? kPi : 0.0f});
  return places;
}

// What hangs in the bays, by side: r, g, b for a drape of that colour, a dot for none.
constexpr const char* kCurtainColors[2] = {".g.r.b.", ".r.b.g."};
constexpr const char* kBannerColors[2] = {"b..g..r", "g..r..b"};

std::vector<Part::Place> drape_places(const char* const colors[2], char color, float y, float z) {
  std::vector<Part::Place> places;
  for (int side = 0; side < 2; ++side) {
    const float s = side == 0 ? -1.0f : 1.0f;
    for (int bay = 0; bay < kBays; ++bay)
      if (colors[side][bay] == color)
        places.push_back({{bay_center(bay), y, s * z}, side == 0 ? 0.0f : kPi});
  }
  return places;
}

std::vector<Part> atrium_parts(const AtriumMaterials& m) {
  std::vector<Part> parts;
  using Add = void (*)(MeshBuilder&, const AtriumMaterials&, const Tessellation&);
  const auto add = [&](const char* name, Add function, std::vector<Part::Place> places) {
    parts.push_back({name, [=](MeshBuilder& b, const Tessellation& t) { function(b, m, t); },
                     std::move(places)});
  };
  add("court floor", add_court_floor, {{}});
  add("aisles", add_aisles, {{}});
  add("arcades", add_arcades, {{}});
  add("back walls", add_back_walls, {{}});
  add("end walls", add_end_walls, {{}});
  add("roofs", add_roofs, {{}});
  add("column", add_column, column_places(kStep));
  add("upper column", add_upper_column, column_places(kGalleryFloor + kPedestalHeight));
  add("fountain", add_fountain, {{}});
  std::vector<Part::Place> planters;
  for (const float x : {-9.0f, -4.5f, 4.5f, 9.0f})
    for (const float z : {-2.55f, 2.55f}) planters.push_back({{x, 0, z}, 0.3f * x + z});
  add("planter", add_planter, std::move(planters));

  for (int color = 0; color < 3; ++color) {
    const std::string name = std::string(1, "rgb"[color]);
    parts.push_back({"curtains " + name,
                     [=](MeshBuilder& b, const Tessellation& t) { add_curtains(b, m, color, t); },
                     drape_places(kCurtainColors, "rgb"[color], kStep, kColumnZ)});
    parts.push_back({"banner " + name,
                     [=](MeshBuilder& b, const Tessellation& t) { add_banner(b, m, color, t); },
                     drape_places(kBannerColors, "rgb"[color], kGalleryFloor + 0.78f, 3.2f)});
  }
  return parts;
}

uint64_t count_triangles(const std::vector<Part>& parts, const Tessellation& tessellation) {
  uint64_t count = 0;
  for (const Part& part : parts) {
    MeshBuilder builder(MeshBuilder::Mode::count);
    part.add(builder, tessellation);
    count += builder.triangle_count() * part.places.size();
  }
  return count;
}

// The edge length that brings the count nearest to `triangles`.
Tessellation find_tessellation(const std::vector<Part>& parts, uint32_t triangles) {
  float fine = 0.01f, coarse = 10.0f;
  Tessellation best{coarse};
  int64_t best_error = std::llabs(int64_t(count_triangles(parts, best)) - int64_t(triangles));
  for (int step = 0; step < 24; ++step) {
    const Tessellation middle{std::sqrt(fine * coarse)};
    const int64_t error = int64_t(count_triangles(parts, middle)) - int64_t(triangles);
    if (std::llabs(error) < best_error) {
      best = middle;
      best_error = std::llabs(error);
    }
    (error > 0 ? fine : coarse) = middle.edge_m;
  }
  return best;
}

void add_cameras(Scene& scene) {
  // A slow walk at the entrance end of the court, looking down its length.
  const auto eye = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(-9.6f - 1.2f * std::cos(angle), 1.75f, -0.5f + 1.0f * std::sin(angle));
  };
  const auto target = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(4.0f, 3.3f + 0.4f * std::sin(angle), 0.5f - 0.8f * std::cos(angle));
  };
  const int32_t nave = add_camera(scene, "court", eye(0), target(0), 0.95f);
  animate_camera(scene, nave, 40, eye, target);
  add_camera(scene, "gallery", {-8.3f, 7.3f, -3.2f}, {2.0f, 2.4f, 1.2f}, 0.95f);
  add_camera(scene, "aisle", {9.8f, 1.75f, -5.6f}, {-3.0f, 1.9f, -4.6f}, 0.9f);
}

void add_sun(Scene& scene) {
  Light sun;
  sun.name = "sun";
  sun.kind = LightKind::directional;
  sun.color = {1.0f, 0.95f, 0.86f};
  sun.intensity = kSunLux;
  sun.node = add_node(scene, "sun", {0, 15, 0});

  // Let the lit floor wander across the court and back.
  animate_rotation(scene, sun.node, 40, [](float phase) {
    return look_along(kSunDirection + glm::vec3(0, 0, 1.2f * std::sin(2 * kPi * phase)));
  });
  scene.lights.push_back(sun);
  const float facing = -glm::normalize(kSunDirection).y;
  // Most of the picture is shade: let the sunlit floor be a little brighter than white.
  scene.exposure_ev = exposure_for(kStoneAlbedo, kSunLux * facing) + 0.6f;
}

}  // namespace

Scene make_atrium(uint32_t triangles) {
  Scene scene;
  scene.name = "atrium";
  const AtriumMaterials materials = add_materials(scene);
  const std::vector<Part> parts = atrium_parts(materials);
  const Tessellation tessellation = find_tessellation(parts, triangles);
  add_cameras(scene);
  add_sun(scene);
  for (const Part& part : parts) {
    MeshBuilder builder;
    part.add(builder, tessellation);
    scene.meshes.push_back(builder.finish(part.name));
    for (const Part::Place& place : part.places) {
      const int32_t node = add_node(scene, part.name, place.translation,
                                    glm::angleAxis(place.turn_rad, glm::vec3(0, 1, 0)));
      add_instance(scene, int32_t(scene.meshes.size()) - 1, node);
    }
  }
  return scene;
}

}  // namespace lueur::builtin
