// SPDX-License-Identifier: MIT
// The Cornell box as it stands at Cornell University: geometry and reflectance spectra from the
// Program of Computer Graphics, "Cornell Box Data", www.graphics.cornell.edu/online/box/data.html.
// The spectra (76 samples, 400–700 nm) were integrated against the CIE 1931 observer under D65 and
// brought to linear Rec.709 relative to a perfect white.
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

constexpr glm::vec3 kWhite{0.738f, 0.736f, 0.740f};
constexpr glm::vec3 kGreen{0.069f, 0.398f, 0.087f};
constexpr glm::vec3 kRed{0.490f, 0.050f, 0.051f};

// The lamp's radiance is in proportion to 17 : 12 : 4, as renderers commonly take it.
constexpr glm::vec3 kLampColor{1.0f, 15.6f / 18.4f, 8.0f / 18.4f};
constexpr float kLampRadiance = 1000.0f;  // cd/m² that the lamp's flux stands for
constexpr float kPanelShare = 0.05f;      // of it that the panel itself radiates

constexpr float kScale = 0.01f;         // the data are in millimetres; ten times life size
constexpr float kWallThickness = 0.3f;  // m

// A wall as a slab: `inner` is its inside, counter-clockwise as seen from within the box.
void add_wall(Scene& scene, const char* name, int32_t material, std::array<glm::vec3, 4> inner,
              const Tessellation& tessellation) {
  const glm::vec3 normal = glm::normalize(glm::cross(inner[2] - inner[0], inner[3] - inner[1]));
  const glm::vec3 back = normal * -kWallThickness;
  MeshBuilder builder;
  builder.set_material(material);
  add_hexahedron(builder,
                 {inner[0] + back, inner[1] + back, inner[3] + back, inner[2] + back, inner[0],
                  inner[1], inner[3], inner[2]},
                 tessellation);
  add_mesh(scene, builder.finish(name));
}

// A block on the floor from the four measured corners of its top, in order around it.
Mesh make_block(const char* name, int32_t material, std::array<glm::vec3, 4> top,
                const Tessellation& tessellation) {
  std::array<glm::vec3, 8> corners;
  constexpr int kOrder[4] = {0, 1, 3, 2};  // around the top → bits x, z of the corner
  for (int k = 0; k < 4; ++k) {
    const glm::vec3 p = top[kOrder[k]] * kScale;
    const int corner = (k & 1) | ((k & 2) << 1);
    corners[corner] = {p.x, 0.0f, p.z};
    corners[corner + 2] = p;
  }
  MeshBuilder builder;
  builder.set_material(material);
  add_hexahedron(builder, corners, tessellation);
  return builder.finish(name);
}

void add_walls(Scene& scene, int32_t white, int32_t green, int32_t red) {
  const Tessellation tessellation{0.7f};
  const float t = kWallThickness / kScale;
  const auto corners = [](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    return std::array<glm::vec3, 4>{a * kScale, b * kScale, c * kScale, d * kScale};
  };

  // Let floor, ceiling and back reach past the side walls, so that no light comes in at the edges.
  add_wall(
      scene, "floor", white,
      corners({-t, 0, 559.2f + t}, {549.6f + t, 0, 559.2f + t}, {552.8f + t, 0, 0}, {-t, 0, 0}),
      tessellation);
  add_wall(scene, "ceiling", white,
           corners({-t, 548.8f, 0}, {556 + t, 548.8f, 0}, {556 + t, 548.8f, 559.2f + t},
                   {-t, 548.8f, 559.2f + t}),
           tessellation);
  add_wall(scene, "back wall", white,
           corners({549.6f + t, -t, 559.2f}, {-t, -t, 559.2f}, {-t, 548.8f + t, 559.2f},
                   {556 + t, 548.8f + t, 559.2f}),
           tessellation);
  add_wall(scene, "right wall", green,
           corners({0, 0, 559.2f}, {0, 0, 0}, {0, 548.8f, 0}, {0, 548.8f, 559.2f}), tessellation);
  add_wall(scene, "left wall", red,
           corners({552.8f, 0, 0}, {549.6f, 0, 559.2f}, {556, 548.8f, 559.2f}, {556, 548.8f, 0}),
           tessellation);
}

// The luminous panel and, just below it, a spot with the panel's flux; both hang on one node that
// slides from its measured place to the left and right. The spot carries the light; the panel
// itself glows with a twentieth of it, which still is far above white in the picture: with all of
// it, every renderer that lets emission light other surfaces would count the lamp twice.
void add_lamp(Scene& scene) {
  Material panel;
  panel.name = "lamp";
  panel.base_color = {0.78f, 0.78f, 0.78f, 1.0f};
  panel.metallic = 0.0f;
  panel.emission = kLampColor * kLampRadiance * kPanelShare;
  scene.materials.push_back(panel);

  const glm::vec3 place = glm::vec3(278.0f, 548.8f, 279.5f) * kScale;
  const int32_t lamp = add_node(scene, "lamp", place);
  const glm::vec2 half_size = glm::vec2(65.0f, 52.5f) * kScale;
  const float drop = 0.02f;  // m below the ceiling
  MeshBuilder builder;
  builder.set_material(int32_t(scene.materials.size()) - 1);
  add_box(builder, {-half_size.x, -drop, -half_size.y}, {half_size.x, 0.1f, half_size.y},
          Tessellation{1.0f});
  scene.meshes.push_back(builder.finish("lamp panel"));
  add_instance(scene, int32_t(scene.meshes.size()) - 1, lamp);

  // A Lambertian panel gives π L A lumens. A spot that falls off as ((cos - c0) / (1 - c0))² down
  // to c0 = cos(80°) gives 2 π I (1 - c0) / 3.
  Light spot;
  spot.name = "lamp light";
  spot.kind = LightKind::spot;
  spot.node = add_node(scene, "lamp light", {0, -drop - 0.01f, 0}, look_along({0, -1, 0}), lamp);
  spot.color = kLampColor;
  spot.inner_cone_rad = 0.0f;
  spot.outer_cone_rad = 80.0f * kPi / 180.0f;
  const float flux = kPi * kLampRadiance * 4.0f * half_size.x * half_size.y;
  spot.intensity = 3.0f * flux / (2.0f * kPi * (1.0f - std::cos(spot.outer_cone_rad)));
  scene.lights.push_back(spot);

  animate_translation(scene, lamp, 40, [=](float phase) {
    return place + glm::vec3(1.2f * std::sin(2 * kPi * phase), 0, 0);
  });

  // Expose for the floor under the lamp.
  const float distance = place.y - drop;
  scene.exposure_ev = exposure_for(kWhite.x, spot.intensity / (distance * distance));
}

}  // namespace

Scene make_cornell() {
  Scene scene;
  scene.name = "cornell";
  const int32_t white = add_material(scene, "white", kWhite, 1.0f);
  const int32_t green = add_material(scene, "green", kGreen, 1.0f);
  const int32_t red = add_material(scene, "red", kRed, 1.0f);

  // The measured camera: 35 mm lens before a film of 25 mm. It is the first node that moves.
  const glm::vec3 eye = glm::vec3(278, 273, -800) * kScale;
  const int32_t camera =
      add_camera(scene, "front", eye, eye + glm::vec3(0, 0, 1), 2.0f * std::atan(0.0125f / 0.035f));
  animate_camera(
      scene, camera, 40,
      [=](float phase) {
        const float angle = 2 * kPi * phase;
        return eye + glm::vec3(0.8f * std::sin(angle), 0.4f * std::sin(2 * angle), 0);
      },
      [=](float) { return glm::vec3(eye.x, eye.y, 2.8f); });

  add_walls(scene, white, green, red);
  const Tessellation tessellation{0.4f};
  add_mesh(scene, make_block("short block", white,
                             {glm::vec3(82, 165, 225), glm::vec3(130, 165, 65),
                              glm::vec3(290, 165, 114), glm::vec3(240, 165, 272)},
                             tessellation));
  add_mesh(scene, make_block("tall block", white,
                             {glm::vec3(265, 330, 296), glm::vec3(423, 330, 247),
                              glm::vec3(472, 330, 406), glm::vec3(314, 330, 456)},
                             tessellation));
  add_lamp(scene);
  return scene;
}

}  // namespace lueur::builtin
