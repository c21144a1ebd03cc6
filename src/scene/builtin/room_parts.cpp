// SPDX-License-Identifier: MIT
#include "scene/builtin/room_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/builtin/scene_builder.h"

namespace lueur::builtin {
namespace {

// 0 in a joint of `half_width` at both ends of [0, 1), 1 inside.
float beside_joint(float share, float half_width) {
  return glm::smoothstep(0.5f * half_width, 1.5f * half_width, std::min(share, 1.0f - share));
}

struct Board {
  uint32_t number, piece;
  float across, along;  // 0 … 1
};
constexpr int kBoards = 8;
Board find_board(glm::vec2 uv) {
  const float position = uv.y * kBoards;
  const uint32_t number = uint32_t(std::clamp(int(position), 0, kBoards - 1));
  const float shifted = uv.x + hash_unit(number, 0, 71);
  return {number, uint32_t(shifted), position - float(number), glm::fract(shifted)};
}

// The outline of a skirting board: x into the room, its back in the wall.
Profile skirting_profile(float depth, float height, const Tessellation& tessellation) {
  Profile profile({-0.02f, -0.02f}, tessellation);
  profile.line_to({depth, -0.02f})
      .line_to({depth, 0.72f * height})
      .arc_to({0.55f * depth, 0.82f * height}, -1.2f, 3)
      .arc_to({0.30f * depth, height}, 1.2f, 3)
      .line_to({-0.02f, height})
      .line_to({-0.02f, -0.02f});
  return profile;
}

}  // namespace

Pattern plaster_pattern() {
  return {[](glm::vec2 uv) {
            const float cloud = tiling_noise(uv, 4, 5, 61), grain = tiling_noise(uv, 48, 2, 62);
            return glm::vec3(0.80f + 0.14f * cloud + 0.04f * (grain - 0.5f));
          },
          [](glm::vec2 uv) {
            return 0.006f * tiling_noise(uv, 6, 3, 63) + 0.0022f * tiling_noise(uv, 32, 3, 64);
          }};
}

Pattern board_pattern(glm::vec3 dark, glm::vec3 light) {
  return {[=](glm::vec2 uv) {
            const Board board = find_board(uv);
            const uint32_t seed = 72 + 2 * board.number + board.piece;
            const float grain = tiling_noise({uv.x, glm::fract(uv.y * 6.0f)}, 4, 5, seed);
            glm::vec3 tone = glm::mix(dark, light, grain);
            tone *= 0.80f + 0.30f * hash_unit(board.number, board.piece, 73);
            return tone *
                   glm::mix(0.30f, 1.0f,
                            beside_joint(board.across, 0.02f) * beside_joint(board.along, 0.0025f));
          },
          [](glm::vec2 uv) {
            const Board board = find_board(uv);
            return 0.003f * beside_joint(board.across, 0.025f) * beside_joint(board.along, 0.003f) +
                   0.0006f * tiling_noise({uv.x, glm::fract(uv.y * 6.0f)}, 8, 4, 74);
          }};
}

Pattern tile_pattern() {
  constexpr float kTiles = 4.0f, kJoint = 0.022f;
  const auto in_tile = [](glm::vec2 uv) {
    const glm::vec2 f = glm::fract(uv * kTiles);
    return beside_joint(f.x, kJoint) * beside_joint(f.y, kJoint);
  };
  return {
      [=](glm::vec2 uv) {
        const glm::uvec2 tile(uv * kTiles);
        glm::vec3 tone(0.66f, 0.62f, 0.55f);
        tone *= 0.90f + 0.16f * hash_unit(tile.x, tile.y, 81);
        tone *= 0.84f + 0.30f * tiling_noise(uv, 6, 6, 82);
        return glm::mix(glm::vec3(0.34f, 0.31f, 0.27f), tone, in_tile(uv));
      },
      [=](glm::vec2 uv) { return 0.004f * in_tile(uv) + 0.0015f * tiling_noise(uv, 16, 3, 83); }};
}

int32_t add_patterned_material(Scene& scene, const std::string& name, glm::vec3 tint,
                               float roughness, uint32_t size, float size_m,
                               const Pattern& pattern) {
  const int32_t material = add_material(scene, name, tint, roughness);
  bind_pattern(scene, material, name, size, size_m, pattern);
  return material;
}

int32_t add_tinted_material(Scene& scene, const std::string& name, int32_t material,
                            glm::vec3 tint) {
  Material tinted = scene.materials[material];
  tinted.name = name;
  tinted.base_color = glm::vec4(tint, 1.0f);
  scene.materials.push_back(std::move(tinted));
  return int32_t(scene.materials.size()) - 1;
}

void add_room(Scene& scene, const Room& room, const Tessellation& tessellation) {
  const glm::vec3 lo = room.min, hi = room.max;
  const float t = room.wall_m;
  const auto slab = [&](const char* name, int32_t material, glm::vec3 min, glm::vec3 max,
                        unsigned seen, float texture_m) {
    if (material == kNone) return;
    MeshBuilder builder;
    builder.set_material(material, texture_m);
    add_box(builder, min, max, tessellation, 63u & ~seen);
    add_mesh(scene, builder.finish(name));
  };
  slab("floor", room.floor, {lo.x - t, lo.y - t, lo.z - t}, {hi.x + t, lo.y, hi.z + t}, kPositiveY,
       room.floor_texture_m);
  slab("ceiling", room.ceiling, {lo.x - t, hi.y, lo.z - t}, {hi.x + t, hi.y + t, hi.z + t},
       kNegativeY, room.wall_texture_m);
  slab("left wall", room.left, {lo.x - t, lo.y, lo.z}, {lo.x, hi.y, hi.z}, kPositiveX,
       room.wall_texture_m);
  slab("right wall", room.right, {hi.x, lo.y, lo.z}, {hi.x + t, hi.y, hi.z}, kNegativeX,
       room.wall_texture_m);
  slab("back wall", room.back, {lo.x - t, lo.y, lo.z - t}, {hi.x + t, hi.y, lo.z}, kPositiveZ,
       room.wall_texture_m);
  slab("front wall", room.front, {lo.x - t, lo.y, hi.z}, {hi.x + t, hi.y, hi.z + t}, kNegativeZ,
       room.wall_texture_m);
}

void add_skirting(Scene& scene, const Room& room, const Skirting& skirting) {
  const Tessellation tessellation{0.5f};
  const Profile profile = skirting_profile(skirting.depth_m, skirting.height_m, tessellation);
  MeshBuilder builder;
  builder.set_material(skirting.material);
  const glm::vec3 lo = room.min, hi(room.max.x, room.min.y, room.max.z);
  const auto run = [&](int32_t wall, glm::vec3 start, glm::vec3 end, glm::vec3 out) {
    if (wall == kNone) return;
    add_moulding(builder, profile, {0.0f, 0.5f * skirting.height_m}, start, end, out, tessellation);
  };
  run(room.back, lo, {hi.x, lo.y, lo.z}, {0, 0, 1});
  run(room.front, hi, {lo.x, lo.y, hi.z}, {0, 0, -1});
  run(room.left, {lo.x, lo.y, hi.z}, lo, {1, 0, 0});
  run(room.right, {hi.x, lo.y, lo.z}, hi, {-1, 0, 0});
  add_mesh(scene, builder.finish("skirting"));
}

void add_pierced_slab(MeshBuilder& builder, const Box& slab, const std::vector<Box>& holes,
                      const Tessellation& tessellation) {
  // Cut along all sides of all holes, and leave out the blocks that lie in one.
  std::vector<float> cuts[3];
  for (int axis = 0; axis < 3; ++axis) {
    cuts[axis] = {slab.min[axis], slab.max[axis]};
    for (const Box& hole : holes)
      for (const float cut : {hole.min[axis], hole.max[axis]})
        if (cut > slab.min[axis] && cut < slab.max[axis]) cuts[axis].push_back(cut);
    std::sort(cuts[axis].begin(), cuts[axis].end());
    cuts[axis].erase(std::unique(cuts[axis].begin(), cuts[axis].end()), cuts[axis].end());
  }
  for (size_t x = 0; x + 1 < cuts[0].size(); ++x) {
    for (size_t y = 0; y + 1 < cuts[1].size(); ++y) {
      for (size_t z = 0; z + 1 < cuts[2].size(); ++z) {
        const glm::vec3 min(cuts[0][x], cuts[1][y], cuts[2][z]);
        const glm::vec3 max(cuts[0][x + 1], cuts[1][y + 1], cuts[2][z + 1]);
        const glm::vec3 middle = 0.5f * (min + max);
        const bool open = std::any_of(holes.begin(), holes.end(), [&](const Box& hole) {
          return glm::all(glm::lessThan(hole.min, middle)) &&
                 glm::all(glm::lessThan(middle, hole.max));
        });
        if (!open) add_box(builder, min, max, tessellation);
      }
    }
  }
}

int32_t add_spot_lamp(Scene& scene, const SpotLamp& lamp) {
  // The lens glows a little over white; all the light is the spot's, which stands before it.
  constexpr float kRadius = 0.075f, kLength = 0.22f, kBevel = 0.008f;
  const int32_t node = add_node(scene, lamp.name, lamp.from, look_along(lamp.to - lamp.from));
  const int32_t lens = add_material(scene, lamp.name + " lens", glm::vec3(0.8f));
  const float distance = glm::distance(lamp.from, lamp.to);
  scene.materials[lens].emission =
      lamp.color * (2.0f * lamp.intensity_cd / (kPi * distance * distance));
  const Tessellation tessellation{0.05f};
  MeshBuilder builder;
  // A lathe stands upright: lay it down, its top to the back (+z).
  builder.set_transform({{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0.02f, 1}});
  builder.set_material(lamp.case_material);
  Profile can({0, 0.03f}, tessellation);
  can.line_to({kRadius - 2 * kBevel, 0.03f})
      .line_to({kRadius - 2 * kBevel, kBevel})
      .arc_to({kRadius, kBevel}, kPi, 4)
      .line_to({kRadius, kLength - 0.04f})
      .arc_to({kRadius - 0.04f, kLength}, kPi / 2, 4)
      .line_to({0, kLength});
  add_lathe(builder, can, 32);
  builder.set_material(lens);
  Profile disc({0, 0.012f}, tessellation);
  disc.line_to({kRadius - 2.5f * kBevel, 0.012f})
      .line_to({kRadius - 2.5f * kBevel, 0.026f})
      .line_to({0, 0.026f});
  add_lathe(builder, disc, 32);
  scene.meshes.push_back(builder.finish(lamp.name + " can"));
  add_instance(scene, int32_t(scene.meshes.size()) - 1, node);

  Light light;
  light.name = lamp.name;
  light.kind = LightKind::spot;
  light.node = node;
  light.color = lamp.color;
  light.intensity = lamp.intensity_cd;
  light.outer_cone_rad = lamp.outer_cone_rad;
  light.inner_cone_rad = lamp.inner_cone_rad;
  scene.lights.push_back(light);
  return node;
}

}  // namespace lueur::builtin
