// SPDX-License-Identifier: MIT
// Patterns of scattered pieces: the nearest of jittered points says which piece a place is in.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/builtin/procedural_texture.h"

namespace lueur::builtin {
namespace {

// The nearest of the points scattered over [0, 1)², one in each of `cells` x `cells` squares.
struct Scattered {
  uint32_t column, row;  // the point's square: its number
  float distance;        // to the point, in sides of a square
  float second;          // to the second nearest
};

Scattered find_scattered(glm::vec2 uv, int cells, uint32_t seed) {
  const glm::vec2 p = uv * float(cells);
  const int x0 = int(std::floor(p.x)), y0 = int(std::floor(p.y));
  Scattered nearest{0, 0, INFINITY, INFINITY};
  for (int y = y0 - 1; y <= y0 + 1; ++y) {
    for (int x = x0 - 1; x <= x0 + 1; ++x) {
      const auto column = uint32_t((x % cells + cells) % cells);
      const auto row = uint32_t((y % cells + cells) % cells);
      const glm::vec2 jitter(hash_unit(column, row, seed), hash_unit(column, row, seed + 1));
      const float distance = glm::distance(p, glm::vec2(x, y) + 0.1f + 0.8f * jitter);
      if (distance < nearest.distance) {
        nearest = {column, row, distance, nearest.distance};
      } else {
        nearest.second = std::min(nearest.second, distance);
      }
    }
  }
  return nearest;
}

}  // namespace

Pattern terrazzo_pattern() {
  return {[](glm::vec2 uv) {
            glm::vec3 tone =
                glm::vec3(0.44f, 0.425f, 0.40f) * (0.92f + 0.16f * tiling_noise(uv, 5, 5, 71));
            constexpr glm::vec3 kChips[5] = {{0.56f, 0.54f, 0.49f},
                                             {0.27f, 0.25f, 0.235f},
                                             {0.50f, 0.40f, 0.32f},
                                             {0.36f, 0.37f, 0.38f},
                                             {0.60f, 0.585f, 0.56f}};

            // Lay small chips first, so that large ones lie over them.
            for (const int cells : {60, 40, 26}) {
              const Scattered chip = find_scattered(uv, cells, uint32_t(cells));
              const float kind = hash_unit(chip.column, chip.row, 72);
              const float size = 0.02f + 0.24f * hash_unit(chip.column, chip.row, 73);
              const float inside =
                  glm::smoothstep(0.0f, 0.06f, 0.5f * (chip.second - chip.distance) - 0.25f + size);
              tone = glm::mix(tone, kChips[std::min(int(kind * 5.0f), 4)], inside * 0.9f);
            }
            return tone;
          },
          [](glm::vec2) { return 0.0f; }};
}

Pattern old_stone_pattern() {
  const auto lichen = [](glm::vec2 uv) {
    const Scattered spot = find_scattered(uv, 9, 81);
    const float radius = 0.42f * hash_unit(spot.column, spot.row, 83) - 0.10f;
    const float ragged = 0.25f * (tiling_noise(uv, 40, 3, 84) - 0.5f);
    return glm::smoothstep(0.03f, -0.05f, spot.distance + ragged - radius);
  };
  return {[=](glm::vec2 uv) {
            const float streak = tiling_noise({4.0f * uv.x, uv.y}, 4, 4, 85);
            glm::vec3 tone =
                glm::mix(glm::vec3(0.20f, 0.20f, 0.19f), glm::vec3(0.46f, 0.45f, 0.42f),
                         0.5f * streak + 0.5f * tiling_noise(uv, 5, 6, 86));
            tone = glm::mix(tone, {0.13f, 0.16f, 0.08f},
                            glm::smoothstep(0.52f, 0.72f, tiling_noise(uv, 4, 5, 87)));
            return glm::mix(tone, {0.52f, 0.50f, 0.34f}, 0.7f * lichen(uv));
          },
          [=](glm::vec2 uv) { return 0.012f * tiling_noise(uv, 14, 5, 88) + 0.002f * lichen(uv); }};
}

Pattern clay_pattern() {
  return {[](glm::vec2 uv) {
            const glm::vec3 tone =
                glm::mix(glm::vec3(0.26f, 0.085f, 0.05f), glm::vec3(0.46f, 0.20f, 0.12f),
                         tiling_noise(uv, 4, 6, 91));
            return glm::mix(tone, {0.40f, 0.36f, 0.31f},
                            glm::smoothstep(0.58f, 0.75f, tiling_noise(uv, 7, 5, 92)));
          },
          [](glm::vec2 uv) { return 0.006f * tiling_noise(uv, 24, 4, 93); }};
}

Pattern earth_pattern() {
  // A leaf is an ellipse turned by its own angle.
  const auto leaf = [](glm::vec2 uv, uint32_t* kind) {
    float inside = 0.0f;
    for (const int cells : {17, 23}) {
      const Scattered spot = find_scattered(uv, cells, uint32_t(100 + cells));
      if (hash_unit(spot.column, spot.row, 101) < 0.72f) continue;
      const float here =
          glm::smoothstep(0.30f, 0.24f, spot.distance * (1.0f + tiling_noise(uv, 50, 1, 107)));
      if (here > inside) *kind = spot.column * 7 + spot.row;
      inside = std::max(inside, here);
    }
    return inside;
  };
  return {[=](glm::vec2 uv) {
            glm::vec3 tone = glm::mix(glm::vec3(0.055f, 0.040f, 0.028f),
                                      glm::vec3(0.16f, 0.12f, 0.08f), tiling_noise(uv, 8, 6, 102));
            tone = glm::mix(tone, glm::vec3(0.07f, 0.095f, 0.042f),
                            glm::smoothstep(0.42f, 0.62f, tiling_noise(uv, 3, 6, 103)));
            uint32_t kind = 0;
            const float inside = leaf(uv, &kind);
            const glm::vec3 dry = glm::mix(glm::vec3(0.20f, 0.085f, 0.03f),
                                           glm::vec3(0.27f, 0.18f, 0.07f), hash_unit(kind, 0, 104));
            return glm::mix(tone, dry * (0.7f + 0.6f * tiling_noise(uv, 60, 2, 105)), inside);
          },
          [=](glm::vec2 uv) {
            uint32_t kind = 0;
            return 0.03f * tiling_noise(uv, 20, 5, 106) + 0.008f * leaf(uv, &kind);
          }};
}

Pattern bark_pattern() {
  const auto furrow = [](glm::vec2 uv) { return tiling_noise({5.0f * uv.x, uv.y}, 4, 4, 111); };
  return {[=](glm::vec2 uv) {
            return glm::mix(glm::vec3(0.035f, 0.028f, 0.024f), glm::vec3(0.20f, 0.17f, 0.145f),
                            furrow(uv));
          },
          [=](glm::vec2 uv) { return 0.03f * furrow(uv); }};
}

}  // namespace lueur::builtin
