// SPDX-License-Identifier: MIT
// A double-six set of dominoes, every stone in one of seven colours, toppling along a bend over a
// polished floor. Few and large triangles, after the dominoes of Nalbach, Ritschel, Seidel 2015:
// colours mix in the gaps between stones, where the camera sees only slivers of what lights them.
// Ten times life size, so that it is a room.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

constexpr int kStones = 28, kColors = 7;
constexpr float kWidth = 0.5f, kHeight = 1.0f, kDepth = 0.17f, kBevel = 0.035f;  // m
constexpr float kSpacing = 0.5f;  // m between stones along the row
constexpr float kKeyLux = 2'000.0f, kFloorAlbedo = 0.45f;

constexpr glm::vec3 kStoneColor[kColors] = {
    {0.60f, 0.035f, 0.04f}, {0.78f, 0.23f, 0.03f}, {0.80f, 0.55f, 0.06f}, {0.12f, 0.45f, 0.10f},
    {0.03f, 0.38f, 0.42f},  {0.05f, 0.12f, 0.55f}, {0.32f, 0.06f, 0.45f}};
constexpr glm::vec3 kIvory{0.86f, 0.82f, 0.72f};

// Distance from `p` to the nearest of `count` pips, laid out as on a die, `pitch` apart.
float pip_distance(glm::vec2 p, int count, float pitch) {
  const auto layout = [&](float x, float y) { return glm::length(p - pitch * glm::vec2(x, y)); };
  float nearest = INFINITY;
  if (count % 2 == 1) nearest = layout(0, 0);
  if (count >= 2) nearest = std::min({nearest, layout(-1, -1), layout(1, 1)});
  if (count >= 4) nearest = std::min({nearest, layout(1, -1), layout(-1, 1)});
  if (count == 6) nearest = std::min({nearest, layout(0, -1), layout(0, 1)});
  return nearest;
}

// Textures hold six pictures, three across and two down.
struct AtlasPlace {
  int picture;
  glm::vec2 uv;  // in the picture
};
AtlasPlace find_in_atlas(glm::vec2 uv) {
  const glm::vec2 cell = uv * glm::vec2(3, 2);
  const int column = std::clamp(int(cell.x), 0, 2), row = std::clamp(int(cell.y), 0, 1);
  return {row * 3 + column, cell - glm::vec2(column, row)};
}
glm::vec2 atlas_uv(int picture, glm::vec2 uv) {
  return (glm::vec2(picture % 3, picture / 3) + uv) / glm::vec2(3, 2);
}
constexpr int kBackPicture = 4, kPlainPicture = 5;  // after the four faces of one colour

// The pips of the row's stone `index`: 6-6, 5-6, 4-6 … 0-1, 0-0.
std::array<int, 2> stone_pips(int index) {
  index = kStones - 1 - index;
  int high = 0;
  while (index > high) index -= ++high;
  return {index, high};
}

// How far a place on a stone's face lies outside of what is cut into it, in metres. `p` runs from
// the face's middle, x to the right and y down.
float engraving_distance(int picture, int color, glm::vec2 p) {
  if (picture == kPlainPicture) return 1.0f;
  if (picture == kBackPicture) {
    // Two lozenges within each other and a dot.
    const float lozenge = std::abs(p.x) / 0.19f + std::abs(p.y) / 0.42f - 1.0f;
    const float scale = 0.17f;
    return std::min({std::abs(lozenge) * scale - 0.010f, std::abs(lozenge + 0.22f) * scale - 0.004f,
                     glm::length(p) - 0.05f});
  }
  const std::array<int, 2> pips = stone_pips(picture * kColors + color);
  const float bar = glm::length(p - glm::vec2(std::clamp(p.x, -0.17f, 0.17f), 0)) - 0.010f;
  const int half = p.y < 0 ? 0 : 1;
  const glm::vec2 in_half = p - glm::vec2(0, half == 0 ? -0.25f : 0.25f);
  // Rows of three lie across the stone.
  const float pip = pip_distance({in_half.y, in_half.x}, pips[half], 0.135f) - 0.047f;
  return std::min(bar, pip);
}

Pattern stone_pattern(int color) {
  const auto distance = [color](glm::vec2 uv) {
    const AtlasPlace place = find_in_atlas(uv);
    return engraving_distance(place.picture, color, (place.uv - 0.5f) * glm::vec2(kWidth, kHeight));
  };
  return {[=](glm::vec2 uv) {
            const float ink = 1.0f - glm::smoothstep(-0.003f, 0.003f, distance(uv));
            const glm::vec3 body =
                kStoneColor[color] * (0.88f + 0.24f * tiling_noise(uv, 6, 4, 61));
            return glm::mix(body, kIvory, ink);
          },
          [=](glm::vec2 uv) { return 0.012f * glm::smoothstep(-0.03f, 0.0f, distance(uv)); }};
}

Pattern die_pattern() {
  const auto distance = [](glm::vec2 uv) {
    const AtlasPlace place = find_in_atlas(uv);
    return pip_distance(place.uv - 0.5f, place.picture + 1, 0.25f) - 0.095f;
  };
  return {[=](glm::vec2 uv) {
            return glm::mix(glm::vec3(0.02f, 0.02f, 0.03f), kIvory,
                            glm::smoothstep(-0.008f, 0.008f, distance(uv)));
          },
          [=](glm::vec2 uv) { return 0.03f * glm::smoothstep(-0.06f, 0.0f, distance(uv)); }};
}

// A stone that stands before the origin with the edge over which it falls, towards +z, on the x
// axis. Its pips look to -z.
Mesh make_stone(int index, int32_t material) {
  const auto uv = [=](glm::vec3 p, glm::vec3 out) {
    const glm::vec2 across(p.x / kWidth, 0.5f - p.y / kHeight);
    if (out.z == -1.0f)
      return atlas_uv(index / kColors, glm::vec2(0.5f - across.x, 0.5f + across.y));
    if (out.z == 1.0f) return atlas_uv(kBackPicture, 0.5f + across);
    return atlas_uv(kPlainPicture, glm::vec2(0.5f + 0.5f * across.x, 0.5f + 0.5f * across.y));
  };
  MeshBuilder builder;
  builder.set_material(material);
  add_bevelled_box(builder, {-0.5f * kWidth, 0, -kDepth}, {0.5f * kWidth, kHeight, 0}, kBevel, uv);
  const std::array<int, 2> pips = stone_pips(index);
  return builder.finish("stone " + std::to_string(pips[0]) + "-" + std::to_string(pips[1]));
}

Mesh make_die(int32_t material, float size_m) {
  // One lies opposite six, two opposite five, three opposite four.
  const auto uv = [=](glm::vec3 p, glm::vec3 out) {
    const glm::vec3 q = p / size_m;
    const glm::vec3 to_face = glm::abs(out);
    if (to_face.y >= to_face.x && to_face.y >= to_face.z)
      return atlas_uv(out.y > 0 ? 4 : 1, 0.5f + glm::vec2(q.x, q.z));
    if (to_face.z >= to_face.x) return atlas_uv(out.z > 0 ? 2 : 3, 0.5f + glm::vec2(q.x, q.y));
    return atlas_uv(out.x > 0 ? 5 : 0, 0.5f + glm::vec2(q.z, q.y));
  };
  MeshBuilder builder;
  builder.set_material(material);
  add_bevelled_box(builder, glm::vec3(-0.5f * size_m), glm::vec3(0.5f * size_m), 0.14f * size_m,
                   uv);
  return builder.finish("die");
}

// Where each stone's falling edge is and which way it falls: a bend that swings left and right on
// its way from the camera, evenly paced.
struct Stand {
  glm::vec3 place;
  float turn_rad;  // about y, from +z
};
std::vector<Stand> stand_in_row() {
  std::vector<Stand> stands;
  glm::vec3 place{1.55f, 0, 3.6f};
  constexpr int kSteps = 16;  // between stones
  for (int k = 0; k < kStones; ++k) {
    const auto heading = [](float stone) {
      return kPi + 1.3f * std::sin(2 * kPi * 1.2f * stone / float(kStones - 1));
    };
    stands.push_back({place, heading(float(k))});
    for (int step = 0; step < kSteps; ++step) {
      const float turn = heading(float(k) + (float(step) + 0.5f) / kSteps);
      place += glm::vec3(std::sin(turn), 0, std::cos(turn)) * (kSpacing / kSteps);
    }
  }
  return stands;
}

// The angles of all stones when the fall has reached stone `front`; its fraction tells how far that
// stone has come on its way to the next one. The stones behind lean on the one before them: with
// its face turned by a, the top edge of the stone behind, at angle b, touches it where
//   height sin(b - a) = spacing cos(a) - depth.
// On the inside of a bend the stones' sides are nearer to each other than their middles.
std::array<float, kStones> fall(const std::vector<Stand>& stands, float front) {
  std::array<float, kStones> angle{};
  const auto lean = [&](int k, float a) {
    const float bend = std::abs(stands[k + 1].turn_rad - stands[k].turn_rad);
    const float spacing = kSpacing - 0.5f * kWidth * bend;
    return a + std::asin(std::max(0.0f, spacing * std::cos(a) - kDepth) / kHeight);
  };
  const int leader = int(front);
  const float share = front - float(leader);
  angle[leader] = lean(leader, 0.0f) * share * share;
  for (int k = leader - 1; k >= 0; --k) angle[k] = lean(k, angle[k + 1]);
  return angle;
}

void add_stones(Scene& scene) {
  std::array<int32_t, kColors> material;
  constexpr const char* kNames[kColors] = {"red",  "orange", "yellow", "green",
                                           "teal", "blue",   "violet"};
  for (int color = 0; color < kColors; ++color) {
    material[color] = add_material(scene, kNames[color], glm::vec3(1.0f), 0.25f);
    bind_pattern(scene, material[color], kNames[color], 512, 1.2f, stone_pattern(color));
  }
  const std::vector<Stand> stands = stand_in_row();
  for (int k = 0; k < kStones; ++k) {
    const int32_t node = add_mesh(scene, make_stone(k, material[k % kColors]));
    scene.nodes[node].translation = stands[k].place;

    // The fall runs to the far end of the row and back, as a film run backwards.
    animate_rotation(scene, node, 100, [&](float phase) {
      const float front = 14.5f - 10.5f * std::cos(2 * kPi * (phase + 0.17f));
      return glm::angleAxis(stands[k].turn_rad, glm::vec3(0, 1, 0)) *
             glm::angleAxis(fall(stands, front)[k], glm::vec3(1, 0, 0));
    });
  }
}

void add_dice(Scene& scene) {
  constexpr float kSize = 0.62f;
  const int32_t material = add_material(scene, "die", glm::vec3(1.0f), 0.3f);
  bind_pattern(scene, material, "die", 256, 2.0f, die_pattern());
  const int32_t first = add_mesh(scene, make_die(material, kSize));
  scene.nodes[first].translation = {-1.9f, 0.5f * kSize, 3.0f};
  scene.nodes[first].rotation = glm::angleAxis(0.5f, glm::vec3(0, 1, 0));
  const int32_t second = add_node(
      scene, "second die", {-2.6f, 0.5f * kSize, -2.6f},
      glm::angleAxis(-0.7f, glm::vec3(0, 1, 0)) * glm::angleAxis(0.5f * kPi, glm::vec3(1, 0, 0)));
  add_instance(scene, int32_t(scene.meshes.size()) - 1, second);
}

// Floor and back wall in one sheet, with a quarter of a circle between them.
void add_cove(Scene& scene) {
  const int32_t material = add_material(scene, "polished floor", glm::vec3(1.0f), 0.1f);
  scene.materials[material].metallic = 0.35f;  // a mirror that still has a colour of its own
  scene.materials[material].base_color_texture = int32_t(scene.textures.size());
  scene.textures.push_back(make_color_texture("terrazzo", 512, terrazzo_pattern().albedo));
  MeshBuilder builder;
  builder.set_material(material, 2.2f);
  const Tessellation coarse{100.0f};
  constexpr float kFront = 9.0f, kBack = -8.0f, kRadius = 2.5f, kTop = 7.0f, kThick = 0.3f;
  Profile profile({-kFront, -kThick}, coarse);
  profile.line_to({-kBack + kRadius + kThick, -kThick})
      .line_to({-kBack + kRadius + kThick, kTop})
      .line_to({-kBack + kRadius, kTop})
      .line_to({-kBack + kRadius, kRadius})
      .arc_to({-kBack, 0}, -kPi / 2, 8)
      .line_to({-kFront, 0})
      .line_to({-kFront, -kThick});
  add_sweep(builder, profile, {-kBack + kRadius + 0.5f * kThick, -0.5f * kThick}, 1, [](int k) {
    return SweepFrame{{k == 0 ? 11.0f : -11.0f, 0, 0}, {0, 0, -1}, {0, 1, 0}};
  });
  add_mesh(scene, builder.finish("floor"));
}

}  // namespace

Scene make_dominoes() {
  Scene scene;
  scene.name = "dominoes";
  const glm::vec3 target{0.15f, 0.1f, 0.6f};
  const auto eye = [](float phase) {
    const float angle = 0.16f + 0.28f * std::sin(2 * kPi * phase);
    return glm::vec3(7.6f * std::sin(angle), 3.3f - 0.5f * std::sin(4 * kPi * phase),
                     7.6f * std::cos(angle));
  };
  const int32_t camera = add_camera(scene, "table", eye(0), target, 0.64f);
  animate_camera(scene, camera, 40, eye, [=](float) { return target; });
  add_camera(scene, "floor", {2.3f, 0.75f, 3.4f}, {-0.4f, 0.45f, -0.6f}, 0.8f);
  add_cove(scene);
  add_stones(scene);
  add_dice(scene);
  add_spot_light(scene, "key", {-5.0f, 7.5f, 3.5f}, {0, 0, -0.2f}, {1.0f, 0.90f, 0.76f}, kKeyLux,
                 0.8f);
  add_spot_light(scene, "rim", {9.5f, 4.8f, -5.0f}, {0, 0, 0}, {0.62f, 0.80f, 1.0f}, 0.7f * kKeyLux,
                 0.6f);
  // Both lights overlap.
  scene.exposure_ev = exposure_for(kFloorAlbedo, kKeyLux) - 0.5f;
  return scene;
}

}  // namespace lueur::builtin
