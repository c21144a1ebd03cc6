// SPDX-License-Identifier: MIT
// What is turned, blown or woven: vase, bottle, bowl, candlestick, stalks and the cloth.
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/shapes.h"
#include "scene/builtin/still_life_parts.h"

namespace lueur::builtin {
namespace {

// A smooth line through `points` (radius, height), for profiles whose pieces should not show:
// normals are those of the curve. Ends are kept; `cells` pieces between two points.
void add_turned(MeshBuilder& builder, const std::vector<glm::vec2>& points, int cells,
                int cells_around) {
  const int last = int(points.size()) - 1, rows = last * cells;
  const auto point = [&](int k) {
    // Beyond the ends the curve goes on straight.
    if (k < 0) return 2.0f * points[0] - points[1];
    if (k > last) return 2.0f * points[last] - points[last - 1];
    return points[k];
  };
  const auto curve = [&](int row, bool slope) {
    const int k = std::min(row / cells, last - 1);
    const float t = float(row - k * cells) / float(cells);
    const glm::vec2 a = point(k - 1), b = point(k), c = point(k + 1), d = point(k + 2);
    const glm::vec2 c1 = 0.5f * (c - a), c2 = a - 2.5f * b + 2.0f * c - 0.5f * d,
                    c3 = 0.5f * (d - a) + 1.5f * (b - c);
    if (slope) return c1 + t * (2.0f * c2 + 3.0f * t * c3);
    return row == rows ? points[last] : b + t * (c1 + t * (c2 + t * c3));
  };
  float widest = 0.0f;
  std::vector<float> along{0.0f};
  for (int row = 1; row <= rows; ++row) {
    along.push_back(along.back() + glm::distance(curve(row - 1, false), curve(row, false)));
    widest = std::max(widest, curve(row, false).x);
  }
  builder.add_grid(cells_around, rows,
                   [&](int i, int j) {
                     const glm::vec2 c = unit_circle_point(i, cells_around), p = curve(j, false);
                     const glm::vec2 s = curve(j, true), n = glm::normalize(glm::vec2(s.y, -s.x));
                     const float u = 2 * kPi * widest * float(i) / float(cells_around);
                     const bool pole = (j == 0 && p.x == 0.0f) || (j == rows && p.x == 0.0f);
                     const glm::vec3 normal = pole ? glm::vec3(0, n.y < 0 ? -1 : 1, 0)
                                                   : glm::vec3(n.x * c.x, n.y, -n.x * c.y);
                     return SurfacePoint{{p.x * c.x, p.y, -p.x * c.y}, normal, {u, -along[j]}};
                   },
                   {points.front().x == 0.0f, points.back().x == 0.0f});
}

// Where objects stand, and how far around them the cloth is flat.
struct Flat {
  glm::vec2 place;
  float radius;
};
constexpr std::array<Flat, 9> kFlats{{{{-1.5f, -1.0f}, 1.2f},
                                      {{1.35f, -1.3f}, 1.1f},
                                      {{-2.9f, 1.2f}, 1.9f},
                                      {{2.2f, 1.0f}, 1.5f},
                                      {{4.0f, -1.0f}, 1.6f},
                                      {{-0.6f, 1.9f}, 1.5f},
                                      {{0.5f, 2.6f}, 1.1f},
                                      {{-0.2f, 0.6f}, 0.8f},
                                      {{0.6f, 4.4f}, 1.3f}}};

}  // namespace

void add_vase(MeshBuilder& builder) {
  add_turned(builder,
             {{0, 0},
              {0.55f, 0},
              {0.62f, 0.05f},
              {0.58f, 0.22f},
              {0.86f, 0.85f},
              {kVaseRadius, 1.75f},
              {0.95f, 2.55f},
              {0.52f, 3.05f},
              {0.40f, 3.40f},
              {0.50f, 3.75f},
              {0.66f, 3.90f},
              {0.60f, 3.93f},
              {0.43f, 3.72f},
              {0.32f, 3.40f},
              {0.44f, 3.00f},
              {0.80f, 2.40f},
              {0.90f, 1.60f},
              {0.45f, 0.60f},
              {0, 0.35f}},
             3, 72);
}

void add_bottle(MeshBuilder& builder) {
  add_turned(builder,
             {{0, 0.12f},     {0.45f, 0.05f},  {0.62f, 0},     {0.70f, 0.06f}, {0.72f, 0.25f},
              {0.72f, 1.40f}, {0.72f, 2.45f},  {0.66f, 2.85f}, {0.38f, 3.20f}, {0.25f, 3.55f},
              {0.23f, 4.10f}, {0.235f, 4.26f}, {0.29f, 4.33f}, {0.30f, 4.48f}, {0.25f, 4.56f},
              {0.19f, 4.55f}, {0.17f, 4.40f},  {0.16f, 3.78f}, {0.12f, 3.70f}, {0, 3.70f}},
             3, 56);
}

void add_bowl(MeshBuilder& builder) {
  add_turned(builder,
             {{0, 0.06f},
              {0.60f, 0.06f},
              {0.72f, 0},
              {0.80f, 0.03f},
              {0.78f, 0.20f},
              {1.00f, 0.38f},
              {1.45f, 0.72f},
              {1.70f, 1.15f},
              {1.80f, 1.42f},
              {1.76f, 1.46f},
              {1.64f, 1.18f},
              {1.38f, 0.80f},
              {0.90f, 0.50f},
              {0, kBowlFloor}},
             3, 80);
}

void add_candlestick(MeshBuilder& builder) {
  add_turned(builder,
             {{0, 0},         {0.80f, 0},     {0.86f, 0.06f}, {0.82f, 0.14f}, {0.55f, 0.22f},
              {0.26f, 0.36f}, {0.17f, 0.55f}, {0.30f, 0.72f}, {0.17f, 0.90f}, {0.13f, 1.10f},
              {0.22f, 1.50f}, {0.26f, 1.75f}, {0.13f, 2.05f}, {0.20f, 2.18f}, {0.12f, 2.32f},
              {0.18f, 2.45f}, {0.46f, 2.56f}, {0.50f, 2.61f}, {0.30f, 2.60f}, {0.26f, 2.66f},
              {0.27f, 2.98f}, {0.31f, 3.04f}, {0.27f, 3.10f}, {0, 3.06f}},
             3, 48);
}

void add_candle_stump(MeshBuilder& builder) {
  add_turned(builder,
             {{0, 0},
              {0.19f, 0},
              {0.20f, 0.04f},
              {0.198f, 0.14f},
              {0.19f, 0.80f},
              {0.20f, 1.24f},
              {0.17f, 1.29f},
              {0.08f, 1.20f},
              {0.025f, 1.20f},
              {0.022f, 1.36f},
              {0.016f, 1.40f},
              {0, 1.42f}},
             3, 24);
}

void add_stalk(MeshBuilder& builder, glm::vec3 from, glm::vec3 to, float radius_m) {
  const glm::vec3 bend = 0.12f * glm::length(to - from) * glm::vec3(0.8f, 0, 0.3f);
  add_tapered_tube(builder,
                   {from, glm::mix(from, to, 0.35f) + 0.4f * bend,
                    glm::mix(from, to, 0.7f) + 0.6f * bend, to, to + 0.02f * (to - from)},
                   {radius_m, 0.8f * radius_m, 0.8f * radius_m, 1.3f * radius_m}, 8);
}

void add_poppies(MeshBuilder& builder) {
  for (uint32_t k = 0; k < 9; ++k) {
    const float turn = 2.4f * float(k) + 0.5f, spread = 0.30f + 0.6f * hash_unit(k, 0, 201);
    const float height = 0.75f + 0.8f * hash_unit(k, 0, 202);
    std::vector<glm::vec3> points;
    constexpr int kPoints = 9;
    for (int j = 0; j < kPoints; ++j) {
      const float t = float(j) / float(kPoints - 1);
      const float out = 0.12f + spread * t * t;
      points.emplace_back(out * std::cos(turn), -1.8f + (height + 1.8f) * t, out * std::sin(turn));
    }
    add_tapered_tube(builder, points, std::vector<float>(kPoints, 0.032f), 7);

    // A seed head with its crown.
    const glm::vec3 along = glm::normalize(points[kPoints - 1] - points[kPoints - 2]);
    const glm::vec3 side = glm::normalize(glm::cross(along, glm::vec3(0, 0, 1)));
    builder.set_transform(glm::mat4(glm::vec4(side, 0), glm::vec4(along, 0),
                                    glm::vec4(glm::cross(side, along), 0),
                                    glm::vec4(points.back(), 1)));
    add_turned(builder,
               {{0, -0.12f},
                {0.06f, -0.10f},
                {0.17f, 0.06f},
                {0.19f, 0.20f},
                {0.12f, 0.34f},
                {0.08f, 0.38f},
                {0.19f, 0.42f},
                {0.18f, 0.45f},
                {0, 0.41f}},
               2, 16);
    builder.set_transform(glm::mat4(1.0f));
  }
}

float cloth_height(float x, float z) {
  float folds = 1.0f;
  for (const Flat& flat : kFlats)
    folds *= glm::smoothstep(flat.radius, flat.radius + 1.1f,
                             glm::distance(glm::vec2(x, z), flat.place));

  // Long folds that run from the back left to the front right and bend.
  const float bend = 0.55f * std::sin(0.7f * x + 0.4f * z) + 0.3f * std::sin(1.3f * z - 0.5f * x);
  const auto ridge = [](float phase) {
    const float wave = 0.5f + 0.5f * std::sin(phase);
    return wave * wave * wave;
  };
  const float high = 0.80f * ridge(1.9f * (0.75f * x - 0.66f * z) + 2.2f * bend) +
                     0.42f * ridge(2.7f * (0.45f * x + 0.9f * z) - 1.8f * bend + 1.0f);
  const float creases = 0.014f * std::sin(5.1f * x + 2.0f * bend) * std::sin(4.3f * z - x);
  return 0.04f + high * folds + creases * (0.25f + 0.75f * folds);
}

void add_table_cloth(MeshBuilder& builder) {
  constexpr glm::vec2 kSize{10.4f, 8.6f};
  const auto middle = [=](float u, float v) {
    // Let the edges wander.
    const float x = (u - 0.5f) * kSize.x + 0.22f * std::sin(5.0f * v + 1.0f) * (2.0f * u - 1.0f);
    const float z = -3.4f + v * kSize.y + 0.20f * std::sin(6.0f * u) * (1.0f - v) +
                    0.9f * (u - 0.5f) * (1.0f - v);
    return glm::vec3(x, cloth_height(x, z), z);
  };
  add_cloth(builder, middle, kSize, 0.05f, 120, 100);
}

}  // namespace lueur::builtin
