// SPDX-License-Identifier: MIT
#include "scene/builtin/procedural_texture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {
namespace {

uint8_t to_byte(float value) {
  return uint8_t(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

float srgb_from_linear(float value) {
  return value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
}

Texture empty_texture(std::string name, uint32_t size) {
  Texture texture;
  texture.name = std::move(name);
  texture.width = texture.height = size;
  texture.rgba.reserve(size_t{size} * size * 4);
  return texture;
}

// A cell of a pattern of rectangles: which one, and how far (0 … 1 of its size) to its edges.
struct Cell {
  uint32_t column, row;
  float inset;  // distance to the nearest edge, in units of the repeat
};

Cell find_cell(glm::vec2 uv, int columns, int rows, float stagger) {
  const float row_position = uv.y * float(rows);
  const int row = std::clamp(int(row_position), 0, rows - 1);
  const float shifted = uv.x + ((row & 1) != 0 ? stagger / float(columns) : 0.0f);
  const float column_position = (shifted - std::floor(shifted)) * float(columns);
  const int column = std::clamp(int(column_position), 0, columns - 1);
  const float fx = column_position - float(column), fy = row_position - float(row);
  return {uint32_t(column), uint32_t(row),
          std::min(std::min(fx, 1 - fx) / float(columns), std::min(fy, 1 - fy) / float(rows))};
}

// 0 in a joint of half width `joint`, 1 beyond it, with a soft edge.
float beyond_joint(float inset, float joint) {
  return glm::smoothstep(0.5f * joint, 1.5f * joint, inset);
}

}  // namespace

float hash_unit(uint32_t x, uint32_t y, uint32_t seed) {
  uint32_t h = x * 0x9e3779b1u ^ (y + 0x7f4a7c15u) * 0x85ebca77u ^ (seed + 1u) * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 12;
  h *= 0x297a2d39u;
  h ^= h >> 15;
  return float(h >> 8) * (1.0f / 16777216.0f);
}

float tiling_noise(glm::vec2 uv, int cells, int octaves, uint32_t seed) {
  float sum = 0.0f, weight = 1.0f, total = 0.0f;
  for (int octave = 0; octave < octaves; ++octave, cells *= 2, weight *= 0.5f) {
    const glm::vec2 p = uv * float(cells), base = glm::floor(p);
    const glm::vec2 f = p - base, s = f * f * (3.0f - 2.0f * f);
    const auto corner = [&](int dx, int dy) {
      const int x = ((int(base.x) + dx) % cells + cells) % cells;
      const int y = ((int(base.y) + dy) % cells + cells) % cells;
      return hash_unit(uint32_t(x), uint32_t(y), seed * 31u + uint32_t(octave));
    };
    sum += weight * glm::mix(glm::mix(corner(0, 0), corner(1, 0), s.x),
                             glm::mix(corner(0, 1), corner(1, 1), s.x), s.y);
    total += weight;
  }
  return sum / total;
}

Texture make_color_texture(std::string name, uint32_t size,
                           const std::function<glm::vec3(glm::vec2 uv)>& albedo) {
  Texture texture = empty_texture(std::move(name), size);
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const glm::vec3 color = albedo((glm::vec2(x, y) + 0.5f) / float(size));
      for (int c = 0; c < 3; ++c) texture.rgba.push_back(to_byte(srgb_from_linear(color[c])));
      texture.rgba.push_back(255);
    }
  }
  return texture;
}

Texture make_normal_texture(std::string name, uint32_t size, float size_m,
                            const std::function<float(glm::vec2 uv)>& height_m) {
  std::vector<float> height;
  for (uint32_t y = 0; y < size; ++y)
    for (uint32_t x = 0; x < size; ++x)
      height.push_back(height_m((glm::vec2(x, y) + 0.5f) / float(size)));
  const auto at = [&](uint32_t x, uint32_t y) { return height[(y % size) * size + x % size]; };

  // Take the slope over two texels; the green channel points to the top of the texture.
  Texture texture = empty_texture(std::move(name), size);
  const float run_m = 2.0f * size_m / float(size);
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const float slope_right = (at(x + 1, y) - at(x + size - 1, y)) / run_m;
      const float slope_up = (at(x, y + size - 1) - at(x, y + 1)) / run_m;
      const glm::vec3 normal = glm::normalize(glm::vec3(-slope_right, -slope_up, 1.0f));
      for (int c = 0; c < 3; ++c) texture.rgba.push_back(to_byte(normal[c] * 0.5f + 0.5f));
      texture.rgba.push_back(255);
    }
  }
  return texture;
}

Pattern pavement_pattern() {
  constexpr float kJoint = 0.006f;
  return {[](glm::vec2 uv) {
            const Cell cell = find_cell(uv, 4, 4, 0.0f);
            const bool dark = ((cell.column + cell.row) & 1) != 0;
            glm::vec3 tone = dark ? glm::vec3(0.33f, 0.21f, 0.15f) : glm::vec3(0.58f, 0.52f, 0.43f);
            tone *= 0.88f + 0.24f * hash_unit(cell.column, cell.row, 11);
            tone *= 0.80f + 0.40f * tiling_noise(uv, 8, 5, 3);
            return glm::mix(glm::vec3(0.20f, 0.18f, 0.16f), tone, beyond_joint(cell.inset, kJoint));
          },
          [](glm::vec2 uv) {
            const Cell cell = find_cell(uv, 4, 4, 0.0f);
            return 0.006f * beyond_joint(cell.inset, kJoint) + 0.002f * tiling_noise(uv, 12, 4, 5);
          }};
}

Pattern masonry_pattern() {
  constexpr float kJoint = 0.005f;
  return {[](glm::vec2 uv) {
            const Cell cell = find_cell(uv, 2, 4, 0.5f);
            glm::vec3 tone =
                glm::mix(glm::vec3(0.60f, 0.50f, 0.38f), glm::vec3(0.66f, 0.60f, 0.50f),
                         hash_unit(cell.column, cell.row, 21));
            tone *= 0.92f + 0.16f * hash_unit(cell.column, cell.row, 22);
            tone *= 0.78f + 0.44f * tiling_noise(uv, 6, 6, 23);
            return tone * glm::mix(0.55f, 1.0f, beyond_joint(cell.inset, kJoint));
          },
          [](glm::vec2 uv) {
            const Cell cell = find_cell(uv, 2, 4, 0.5f);
            return 0.010f * beyond_joint(cell.inset, kJoint) + 0.008f * tiling_noise(uv, 16, 4, 24);
          }};
}

Pattern limestone_pattern() {
  return {[](glm::vec2 uv) {
            const float cloud = tiling_noise(uv, 3, 6, 31), grain = tiling_noise(uv, 64, 2, 32);
            return glm::mix(glm::vec3(0.60f, 0.54f, 0.44f), glm::vec3(0.74f, 0.69f, 0.60f), cloud) *
                   (0.93f + 0.14f * grain);
          },
          [](glm::vec2 uv) { return 0.004f * tiling_noise(uv, 24, 4, 33); }};
}

Pattern cloth_pattern() {
  constexpr float kThreads = 48.0f;  // a repeat, both ways
  return {[](glm::vec2 uv) {
            const glm::vec2 wave = glm::sin(uv * (2.0f * kPi * kThreads));
            return glm::vec3(0.86f + 0.07f * wave.x * wave.y +
                             0.14f * (tiling_noise(uv, 6, 4, 41) - 0.5f));
          },
          [](glm::vec2 uv) {
            const glm::vec2 wave = glm::sin(uv * (2.0f * kPi * kThreads));
            return 0.0006f * wave.x * wave.y;
          }};
}

Pattern wood_pattern() {
  return {
      [](glm::vec2 uv) {
        const Cell cell = find_cell(uv, 6, 1, 0.0f);
        const float grain =
            tiling_noise({uv.x * 8.0f - std::floor(uv.x * 8.0f), uv.y}, 4, 4, 51 + cell.column);
        const glm::vec3 tone =
            glm::mix(glm::vec3(0.12f, 0.06f, 0.03f), glm::vec3(0.28f, 0.16f, 0.08f), grain);
        return tone * (0.8f + 0.4f * hash_unit(cell.column, 0, 52)) *
               glm::mix(0.35f, 1.0f, beyond_joint(cell.inset, 0.006f));
      },
      [](glm::vec2 uv) { return 0.008f * beyond_joint(find_cell(uv, 6, 1, 0.0f).inset, 0.006f); }};
}

void bind_pattern(Scene& scene, int32_t material, const std::string& name, uint32_t size,
                  float size_m, const Pattern& pattern) {
  scene.materials[material].base_color_texture = int32_t(scene.textures.size());
  scene.textures.push_back(make_color_texture(name + " colour", size, pattern.albedo));
  scene.materials[material].normal_texture = int32_t(scene.textures.size());
  scene.textures.push_back(make_normal_texture(name + " normal", size, size_m, pattern.height_m));
}

}  // namespace lueur::builtin
