// SPDX-License-Identifier: MIT
// A still life of glossy and diffuse things on a cloth, after the one of Nalbach, Ritschel, Seidel
// 2015. Two of its things are hard for methods that know only what the camera sees: a hollow skull,
// whose inside the lit cloth must not light through the bone, and large letters below the picture
// that throw their colours into it. Ten times life size, so that it is a room.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/scenes.h"
#include "scene/builtin/shapes.h"
#include "scene/builtin/still_life_parts.h"

namespace lueur::builtin {
namespace {

constexpr float kKeyLux = 1'500.0f, kPaleAlbedo = 0.6f;
constexpr float kLettersZ = 8.3f;

// Cobalt on white glaze: bands, and between them a leafy scroll. `v` runs along the vase's profile,
// wherefore the height is cut out of it.
Pattern painted_pattern() {
  const auto paint = [](glm::vec2 uv) {
    const glm::vec2 p(uv.x - 0.5f, uv.y - 0.5f);
    const auto petal = [&](float turn, float length) {
      const glm::vec2 along(std::cos(turn), std::sin(turn));
      const float t = glm::dot(p, along), across = std::abs(p.x * along.y - p.y * along.x);
      const float width = 0.085f * std::sin(kPi * std::clamp(t / length, 0.0f, 1.0f));
      return glm::smoothstep(0.012f, -0.012f, across - width);
    };
    float ink = 0.0f;
    for (int k = 0; k < 8; ++k)
      ink = std::max(ink, petal(0.25f * kPi * float(k), (k & 1) != 0 ? 0.28f : 0.40f));
    const float ring = glm::length(p);
    ink = std::max(ink * glm::smoothstep(0.06f, 0.075f, ring), glm::smoothstep(0.05f, 0.04f, ring));
    for (const float y : {0.02f, 0.055f, 0.98f})
      ink = std::max(ink, glm::smoothstep(0.014f, 0.008f, std::abs(uv.y - y)));
    const float scroll = std::abs(uv.y - 0.90f + 0.02f * std::sin(4 * kPi * uv.x));
    return std::max(ink, glm::smoothstep(0.016f, 0.008f, scroll));
  };
  return {[=](glm::vec2 uv) {
            const float wash = 0.75f + 0.5f * tiling_noise(uv, 8, 3, 211);
            const glm::vec3 cobalt = glm::vec3(0.03f, 0.07f, 0.34f) * wash;
            return glm::mix(glm::vec3(0.74f, 0.77f, 0.78f), cobalt, paint(uv));
          },
          [=](glm::vec2 uv) { return 0.01f * paint(uv); }};
}

// Woven in two ways that shine differently: blossoms on a plain ground.
Pattern damask_pattern() {
  const auto figure = [](glm::vec2 uv) {
    float inside = 0.0f;

    // Two blossoms a repeat, the second half a repeat away both ways.
    for (const float shift : {0.0f, 0.5f}) {
      const glm::vec2 p = glm::fract(uv + shift) - 0.5f;
      const float ring = glm::length(p), turn = std::atan2(p.y, p.x);
      const float edge = 0.15f + 0.055f * std::cos(8.0f * turn) + 0.03f * std::cos(4.0f * turn);
      inside = std::max(inside, glm::smoothstep(0.008f, -0.008f, ring - edge) *
                                    glm::smoothstep(0.05f, 0.06f, ring));
      inside = std::max(inside, glm::smoothstep(0.012f, 0.004f, std::abs(ring - 0.275f)));
    }
    return inside;
  };
  const Pattern weave = cloth_pattern();
  return {[=](glm::vec2 uv) { return weave.albedo(uv) * (0.72f + 0.42f * figure(uv)); },
          [=](glm::vec2 uv) { return weave.height_m(uv) + 0.006f * figure(uv); }};
}

// Skins: near white with fine dots and broad clouds; coloured by the material.
Pattern skin_pattern() {
  return {[](glm::vec2 uv) {
            const float dots = glm::smoothstep(0.66f, 0.78f, tiling_noise(uv, 90, 1, 221));
            const float cloud = tiling_noise(uv, 4, 4, 222);
            return glm::vec3(0.95f, 0.72f + 0.26f * cloud, 0.80f) * (1.0f - 0.28f * dots);
          },
          [](glm::vec2 uv) { return 0.006f * tiling_noise(uv, 60, 2, 223); }};
}

Pattern bone_pattern() {
  return {[](glm::vec2 uv) {
            const float stain = tiling_noise(uv, 5, 6, 231);
            return glm::mix(glm::vec3(0.40f, 0.31f, 0.19f), glm::vec3(0.74f, 0.67f, 0.53f),
                            glm::smoothstep(0.25f, 0.65f, stain));
          },
          [](glm::vec2 uv) {
            return 0.012f * tiling_noise(uv, 12, 5, 232) +
                   0.006f * glm::smoothstep(0.45f, 0.5f, tiling_noise(uv, 9, 2, 233));
          }};
}

struct Materials {
  int32_t wall, wood, cloth, vase, bottle, bowl, brass, wax, bone, dry, pear, apple, lemon, grape,
      wood_stalk, paper, leather;
};

Materials add_materials(Scene& scene) {
  Materials m{};
  const auto patterned = [&](const char* name, glm::vec3 color, float roughness, uint32_t size,
                             float size_m, const Pattern& pattern) {
    const int32_t material = add_material(scene, name, color, roughness);
    bind_pattern(scene, material, name, size, size_m, pattern);
    return material;
  };
  const auto like = [&](int32_t other, const char* name, glm::vec3 color, float roughness) {
    const int32_t material = add_material(scene, name, color, roughness);
    scene.materials[material].base_color_texture = scene.materials[other].base_color_texture;
    scene.materials[material].normal_texture = scene.materials[other].normal_texture;
    return material;
  };
  m.wall = patterned("wall", {0.62f, 0.60f, 0.48f}, 0.95f, 256, 6.0f, limestone_pattern());
  m.wood = patterned("table", {1.0f, 0.85f, 0.7f}, 0.35f, 512, 5.0f, wood_pattern());
  m.cloth = patterned("cloth", {0.46f, 0.045f, 0.035f}, 0.85f, 512, 2.2f, damask_pattern());
  m.vase = patterned("vase", glm::vec3(1.0f), 0.12f, 512, 1.2f, painted_pattern());
  m.bottle = add_material(scene, "bottle", {0.02f, 0.07f, 0.035f}, 0.1f);
  m.bowl = add_material(scene, "bowl", {0.10f, 0.30f, 0.33f}, 0.18f);
  m.brass = add_material(scene, "brass", {0.78f, 0.56f, 0.26f}, 0.24f);
  scene.materials[m.brass].metallic = 1.0f;
  m.wax = add_material(scene, "wax", {0.78f, 0.72f, 0.58f}, 0.5f);
  m.bone = patterned("bone", glm::vec3(1.0f), 0.6f, 512, 2.0f, bone_pattern());
  m.dry = add_material(scene, "dry stalks", {0.34f, 0.26f, 0.15f}, 0.85f);
  m.pear = patterned("pear", {0.62f, 0.62f, 0.13f}, 0.38f, 256, 1.1f, skin_pattern());
  m.apple = like(m.pear, "apple", {0.62f, 0.05f, 0.035f}, 0.25f);
  scene.materials[m.apple].normal_scale = 0.15f;
  m.lemon = like(m.pear, "lemon", {0.85f, 0.66f, 0.06f}, 0.42f);
  scene.materials[m.pear].normal_scale = 0.3f;
  m.grape = add_material(scene, "grape", {0.11f, 0.03f, 0.13f}, 0.22f);
  m.wood_stalk = add_material(scene, "stalk", {0.14f, 0.085f, 0.045f}, 0.9f);
  m.paper = add_material(scene, "paper", {0.66f, 0.60f, 0.48f}, 0.95f);
  m.leather = add_material(scene, "leather", {0.07f, 0.12f, 0.09f}, 0.5f);
  return m;
}

void add_room(Scene& scene, const Materials& m) {
  const Tessellation coarse{3.0f};
  MeshBuilder builder;
  builder.set_material(m.wall, 6.0f);
  add_box(builder, {-16, -8, -8.5f}, {16, 14, -8.0f}, coarse, kNegativeZ);
  add_mesh(scene, builder.finish("wall"));
  builder.set_material(m.wall, 6.0f);
  add_box(builder, {-16, -8, 14.0f}, {16, 14, 14.5f}, coarse, kPositiveZ);
  add_mesh(scene, builder.finish("wall behind the camera"));
  builder.set_material(m.wood, 5.0f);
  add_bevelled_box(builder, {-8.5f, -0.6f, -5.2f}, {8.5f, 0.0f, 9.5f}, 0.12f,
                   [](glm::vec3 p, glm::vec3 out) {
                     const glm::vec2 uv = planar_uv(p, out);
                     return glm::vec2(uv.y, uv.x);  // planks run from left to right
                   });
  add_mesh(scene, builder.finish("table"));
  builder.set_material(m.cloth, 2.2f);
  add_table_cloth(builder);
  add_mesh(scene, builder.finish("cloth"));
}

// Puts what `add` makes at a place on the cloth.
template <class Add>
int32_t add_thing(Scene& scene, const char* name, int32_t material, glm::vec3 place,
                  glm::quat rotation, Add&& add, float texture_size_m = 1.0f) {
  MeshBuilder builder;
  builder.set_material(material, texture_size_m);
  add(builder);
  const int32_t node = add_mesh(scene, builder.finish(name));
  scene.nodes[node].translation = place;
  scene.nodes[node].rotation = rotation;
  return node;
}

glm::quat about(glm::vec3 axis, float angle_rad) {
  return glm::angleAxis(angle_rad, glm::normalize(axis));
}
constexpr glm::vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
const glm::quat kUpright{1, 0, 0, 0};
constexpr float kOnCloth = 0.065f;  // its upper side where it lies flat

void add_vessels(Scene& scene, const Materials& m) {
  const glm::vec3 vase{-1.5f, kOnCloth, -1.0f};
  add_thing(scene, "vase", m.vase, vase, kUpright, add_vase,
            2 * kPi * kVaseRadius / float(kVaseRepeats));
  add_thing(scene, "poppies", m.dry, vase + glm::vec3(0, 3.55f, 0), kUpright, add_poppies);
  add_thing(scene, "bottle", m.bottle, {1.35f, kOnCloth, -1.3f}, kUpright, add_bottle);
  add_thing(scene, "bowl", m.bowl, {-2.9f, kOnCloth, 1.2f}, kUpright, add_bowl);

  // Two books, and the candlestick on them.
  const auto add_book = [&](MeshBuilder& builder, glm::vec3 low, glm::vec3 high) {
    builder.set_material(m.paper);
    add_box(builder, low + glm::vec3(0.02f, 0.06f, 0.07f), high - glm::vec3(0.07f, 0.06f, 0.07f),
            Tessellation{9.0f});
    builder.set_material(m.leather);
    add_bevelled_box(builder, low, {high.x, low.y + 0.09f, high.z}, 0.025f);
    add_bevelled_box(builder, {low.x, high.y - 0.09f, low.z}, high, 0.025f);
    add_bevelled_box(builder, low, {low.x + 0.09f, high.y, high.z}, 0.03f);
  };
  const glm::vec3 books{4.0f, kOnCloth, -1.0f};
  add_thing(scene, "lower book", m.leather, books, about(kY, -0.25f), [&](MeshBuilder& builder) {
    add_book(builder, {-1.1f, 0, -1.4f}, {1.1f, 0.42f, 1.4f});
  });
  add_thing(scene, "upper book", m.leather, books + glm::vec3(0.05f, 0.42f, -0.05f),
            about(kY, 0.15f), [&](MeshBuilder& builder) {
              add_book(builder, {-0.95f, 0, -1.2f}, {0.95f, 0.34f, 1.2f});
            });
  const glm::vec3 stand = books + glm::vec3(0.0f, 0.76f, -0.1f);
  add_thing(scene, "candlestick", m.brass, stand, kUpright, add_candlestick);
  add_thing(scene, "candle", m.wax, stand + glm::vec3(0, 3.02f, 0), about(kZ, 0.02f),
            add_candle_stump);
}

// Places and radii of the grapes of one bunch that hangs out of the bowl.
std::vector<glm::vec4> bunch_of_grapes(glm::vec3 bowl) {
  constexpr int kGrapes = 44;
  std::vector<glm::vec4> grapes;
  for (uint32_t k = 0; k < kGrapes; ++k) {
    const auto chance = [&](uint32_t seed) { return hash_unit(k, 0, seed) - 0.5f; };
    const float t = float(k) / float(kGrapes - 1), over = glm::smoothstep(0.1f, 0.6f, t);
    const glm::vec3 middle =
        bowl + glm::vec3(1.05f + 1.40f * t, 1.72f - 1.45f * over, 0.55f + 0.9f * t);
    grapes.emplace_back(middle + 0.5f * glm::vec3(chance(242), chance(243), chance(244)),
                        0.165f + 0.03f * chance(241));
  }

  // Draw the bunch together, then push apart what overlaps, and out of the cloth.
  for (int round = 0; round < 80; ++round) {
    for (size_t a = 1; a < grapes.size() && round < 40; ++a)
      grapes[a] += glm::vec4(0.12f * glm::vec3(grapes[a - 1] - grapes[a]), 0.0f);
    for (size_t a = 0; a < grapes.size(); ++a) {
      for (size_t b = a + 1; b < grapes.size(); ++b) {
        const glm::vec3 apart = glm::vec3(grapes[b]) - glm::vec3(grapes[a]);
        const float distance = glm::length(apart), lack = grapes[a].w + grapes[b].w - distance;
        if (lack <= 0.0f) continue;
        const glm::vec4 push(apart * (0.5f * lack / distance), 0.0f);
        grapes[a] -= push;
        grapes[b] += push;
      }
    }
    for (glm::vec4& grape : grapes) grape.y = std::max(grape.y, kOnCloth + grape.w);
  }
  return grapes;
}

void add_fruit(Scene& scene, const Materials& m) {
  const glm::vec3 bowl{-2.9f, kOnCloth, 1.2f};
  struct Piece {
    glm::vec3 place;
    glm::quat rotation;
  };
  const auto add_pieces = [&](const char* name, int32_t material, void (*add)(MeshBuilder&),
                              std::initializer_list<Piece> pieces) {
    MeshBuilder builder;
    builder.set_material(material, 1.1f);
    add(builder);
    scene.meshes.push_back(builder.finish(name));
    for (const Piece& piece : pieces)
      add_instance(scene, int32_t(scene.meshes.size()) - 1,
                   add_node(scene, name, piece.place, piece.rotation));
  };
  add_pieces("pear", m.pear, add_pear,
             {{bowl + glm::vec3(-0.72f, 0.70f, 0.30f), about({0.3f, 0, 1}, 0.55f)},
              {bowl + glm::vec3(0.10f, 0.66f, -0.75f), about({1, 0, 0.2f}, -0.5f)},
              {{-0.75f, kOnCloth, 1.75f}, about({0.2f, 1, 0.1f}, 0.4f)},
              {{-1.05f, kOnCloth + 0.46f, 2.75f}, about({0.15f, 0.1f, 1}, 1.45f)}});
  add_pieces("apple", m.apple, add_apple,
             {{bowl + glm::vec3(0.70f, 1.02f, 0.25f), about({1, 0, 0.4f}, 0.35f)},
              {bowl + glm::vec3(-0.35f, 1.42f, -0.15f), about({0.2f, 0, 1}, -0.3f)},
              {bowl + glm::vec3(-0.85f, 1.00f, -0.55f), about({1, 0, 1}, 0.6f)}});
  add_pieces("lemon", m.lemon, add_lemon,
             {{bowl + glm::vec3(0.15f, 1.05f, 0.85f), about({0, 1, 0.3f}, 0.5f)},
              {{0.10f, kOnCloth + 0.37f, 0.55f}, about({0, 1, 0.05f}, -0.7f)}});

  // Stalks of the pears and apples that lie open to the view.
  MeshBuilder stalks;
  stalks.set_material(m.wood_stalk);
  add_stalk(stalks, {-0.70f, kOnCloth + 1.22f, 1.78f}, {-0.62f, kOnCloth + 1.62f, 1.80f}, 0.035f);
  add_stalk(stalks, {-2.28f, kOnCloth + 0.62f, 2.80f}, {-2.62f, kOnCloth + 0.70f, 2.85f}, 0.035f);
  add_stalk(stalks, bowl + glm::vec3(-0.30f, 1.55f, -0.15f), bowl + glm::vec3(-0.18f, 2.08f, -0.2f),
            0.03f);
  add_mesh(scene, stalks.finish("stalks"));

  // Grapes hang over the bowl's rim and lie before it.
  MeshBuilder grapes;
  grapes.set_material(m.grape);
  for (const glm::vec4& grape : bunch_of_grapes(bowl))
    add_sphere(grapes, glm::vec3(grape), grape.w, 16);
  grapes.set_material(m.wood_stalk);
  add_tapered_tube(grapes,
                   {bowl + glm::vec3(0.75f, 1.55f, 0.40f), bowl + glm::vec3(1.15f, 1.75f, 0.60f),
                    bowl + glm::vec3(1.60f, 1.35f, 0.90f), bowl + glm::vec3(1.95f, 0.65f, 1.10f),
                    bowl + glm::vec3(2.40f, 0.22f, 1.40f)},
                   {0.045f, 0.04f, 0.035f, 0.03f}, 8);
  add_mesh(scene, grapes.finish("grapes"));

  // One apple rolls to and fro before the others.
  const int32_t rolling = add_thing(scene, "rolling apple", m.apple, {}, kUpright, add_apple, 1.1f);
  const auto way = [](float phase) { return 0.55f * std::sin(2 * kPi * phase); };
  animate_translation(scene, rolling, 40, [=](float phase) {
    return glm::vec3(0.55f + way(phase), kOnCloth + 0.485f, 2.55f);
  });
  animate_rotation(scene, rolling, 40, [=](float phase) {
    return about(kZ, -way(phase) / kAppleRadius) * about({1, 0, 0.3f}, 0.9f);
  });
}

// The program's name in French for a light, in letters that only the second camera sees.
void add_letters(Scene& scene) {
  struct Letter {
    char letter;
    const char* name;
    glm::vec3 color;
  };
  constexpr std::array<Letter, 5> kLetters{{{'L', "letter L", {0.80f, 0.04f, 0.03f}},
                                            {'U', "letter U", {0.85f, 0.42f, 0.02f}},
                                            {'E', "letter E", {0.10f, 0.62f, 0.10f}},
                                            {'U', "second letter U", {0.03f, 0.35f, 0.75f}},
                                            {'R', "letter R", {0.55f, 0.05f, 0.60f}}}};
  for (size_t k = 0; k < kLetters.size(); ++k) {
    const Letter& letter = kLetters[k];
    const float x = 2.15f * (2.0f - float(k));  // read from behind the things on the table
    const int32_t material = add_material(scene, letter.name, letter.color, 0.3f);
    add_thing(scene, letter.name, material, {x, 0.0f, kLettersZ - 0.025f * x * x},
              about(kY, kPi + 0.05f * x),
              [&](MeshBuilder& builder) { add_letter(builder, letter.letter); });
  }
}

void add_cameras(Scene& scene) {
  const auto eye = [](float phase) {
    const float angle = 2 * kPi * phase;
    return glm::vec3(0.9f * std::sin(angle), 4.9f + 0.3f * std::cos(angle), 11.3f);
  };
  const glm::vec3 target{0.35f, 2.2f, 0.0f};
  const int32_t table = add_camera(scene, "table", eye(0), target, 0.65f);
  animate_camera(scene, table, 40, eye, [=](float) { return target; });
  add_camera(scene, "letters", {0.3f, 3.5f, -0.9f}, {0.0f, 0.35f, 8.0f}, 0.75f);
  add_camera(scene, "skull", {1.35f, 1.6f, 4.7f}, {2.1f, 0.85f, 1.0f}, 0.60f);
}

void add_lights(Scene& scene) {
  const glm::vec3 window{-9.0f, 9.0f, 5.5f};
  const int32_t key = add_spot_light(scene, "window", window, {0.2f, 0.8f, 0.4f},
                                     {1.0f, 0.88f, 0.70f}, kKeyLux, 0.52f);
  animate_translation(scene, key, 40, [=](float phase) {
    return window + glm::vec3(0, 0, 1.2f * std::sin(2 * kPi * phase));
  });
  add_spot_light(scene, "letters' light", {3.0f, 9.5f, -4.5f}, {0, 1.0f, kLettersZ - 0.3f},
                 {0.92f, 0.96f, 1.0f}, 1.3f * kKeyLux, 0.42f);
  add_spot_light(scene, "wall light", {-4.5f, 9.0f, -3.5f}, {-0.6f, 3.4f, -8.0f},
                 {1.0f, 0.90f, 0.74f}, 0.45f * kKeyLux, 0.75f);
}

}  // namespace

Scene make_still_life() {
  Scene scene;
  scene.name = "still-life";
  const Materials m = add_materials(scene);
  add_cameras(scene);
  add_room(scene, m);
  add_vessels(scene, m);
  add_fruit(scene, m);
  add_thing(scene, "skull", m.bone, {2.2f, kOnCloth + 0.02f, 1.0f},
            about(kY, -0.35f) * about(kX, -0.22f), add_skull, 2.0f);
  add_letters(scene);
  add_lights(scene);
  scene.exposure_ev = exposure_for(kPaleAlbedo, kKeyLux) + 0.2f;
  return scene;
}

}  // namespace lueur::builtin
