// SPDX-License-Identifier: MIT
// What is sculpted with distance functions: skull, letters and fruit.
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "base/check.h"
#include "scene/builtin/isosurface.h"
#include "scene/builtin/sdf.h"
#include "scene/builtin/still_life_parts.h"

namespace lueur::builtin {
namespace {

// The row of teeth of one jaw: `p` on the right half, teeth from y0 to y1.
float teeth(glm::vec3 p, float y0, float y1, float reach) {
  float nearest = 1.0f;
  constexpr int kTeeth = 7;  // on one side
  for (int k = 0; k < kTeeth; ++k) {
    const float angle = 0.115f + 0.205f * float(k);
    const glm::vec3 at(0.335f * std::sin(angle), 0, 0.34f + reach * std::cos(angle));
    const float size = k < 2 ? 0.040f : k > 3 ? 0.050f : 0.038f;
    nearest = std::min(nearest,
                       sdf::capsule(p, at + glm::vec3(0, y0, 0), at + glm::vec3(0, y1, 0), size));
  }
  return nearest;
}

// Face to +z, the jaw's lower edge on y = 0, everything mirrored in x = 0.
float skull(glm::vec3 p) {
  using namespace sdf;
  const glm::vec3 q(std::abs(p.x), p.y, p.z);

  // The outside: cranium, face, brows, cheekbones, upper jaw.
  float bone = ellipsoid(p, {0, 1.10f, -0.20f}, {0.73f, 0.68f, 0.92f});
  bone = smooth_min(bone, ellipsoid(p, {0, 0.70f, 0.38f}, {0.47f, 0.52f, 0.42f}), 0.30f);
  bone = smooth_min(bone, ellipsoid(p, {0, 0.42f, 0.50f}, {0.35f, 0.24f, 0.30f}), 0.12f);
  bone = smooth_max(bone, -ellipsoid(q, {0.86f, 0.86f, 0.26f}, {0.24f, 0.30f, 0.34f}), 0.16f);
  bone = smooth_min(bone, capsule(q, {0.10f, 1.00f, 0.70f}, {0.46f, 0.97f, 0.52f}, 0.085f), 0.12f);
  bone = smooth_min(bone, capsule(q, {0.47f, 0.95f, 0.52f}, {0.50f, 0.70f, 0.50f}, 0.055f), 0.07f);
  bone = smooth_min(bone, capsule(q, {0.28f, 0.60f, 0.68f}, {0.54f, 0.64f, 0.40f}, 0.085f), 0.10f);
  bone = smooth_min(bone, capsule(q, {0.54f, 0.64f, 0.40f}, {0.68f, 0.70f, -0.05f}, 0.050f), 0.06f);
  bone = smooth_min(bone, capsule(q, {0.03f, 0.92f, 0.76f}, {0.03f, 0.74f, 0.84f}, 0.05f), 0.08f);

  // The hollow head, and the ways into it: eyes, nose, and the mouth from below.
  bone = smooth_max(bone, -ellipsoid(p, {0, 1.10f, -0.20f}, {0.56f, 0.58f, 0.82f}), 0.04f);
  bone = smooth_max(bone, -cone(q, {0.285f, 0.82f, 0.84f}, {0.20f, 0.88f, 0.15f}, 0.185f, 0.11f),
                    0.06f);
  const float nose = smooth_min(ellipsoid(q, {0.065f, 0.56f, 0.80f}, {0.075f, 0.10f, 0.45f}),
                                ellipsoid(q, {0, 0.66f, 0.80f}, {0.055f, 0.12f, 0.40f}), 0.05f);
  bone = smooth_max(bone, -nose, 0.03f);
  bone = smooth_max(bone, -ellipsoid(p, {0, 0.22f, 0.38f}, {0.25f, 0.20f, 0.34f}), 0.06f);
  bone = smooth_max(bone, -capsule(p, {0, 0.10f, 0.05f}, {0, 0.80f, 0.0f}, 0.26f), 0.06f);
  bone = smooth_min(bone, teeth(q, 0.22f, 0.31f, 0.42f), 0.035f);

  // The lower jaw hangs a little open.
  float jaw = capsule(q, {0.0f, 0.10f, 0.72f}, {0.20f, 0.10f, 0.64f}, 0.095f);
  jaw = smooth_min(jaw, capsule(q, {0.20f, 0.10f, 0.64f}, {0.46f, 0.15f, 0.10f}, 0.080f), 0.06f);
  jaw = smooth_min(jaw, capsule(q, {0.47f, 0.16f, 0.08f}, {0.55f, 0.62f, -0.08f}, 0.070f), 0.06f);
  jaw = smooth_min(jaw, capsule(q, {0.0f, 0.06f, 0.76f}, {0.10f, 0.06f, 0.74f}, 0.07f), 0.05f);
  jaw = smooth_min(jaw, teeth(q, 0.12f, 0.155f, 0.375f), 0.03f);
  return std::min(bone, jaw);
}

// Distance in the plane to the strokes of a letter in a box of 1.5 x 2.2, from its lower left.
float letter_strokes(glm::vec2 p, char letter) {
  const auto line = [&](glm::vec2 a, glm::vec2 b) {
    return sdf::capsule({p, 0}, {a, 0}, {b, 0}, 0.0f);
  };

  // Half a circle that lies on one side of a line through its middle.
  const auto half_ring = [&](glm::vec2 center, glm::vec2 side, float radius) {
    const glm::vec2 q = p - center, across(-side.y, side.x);
    if (glm::dot(q, side) > 0.0f) return std::abs(glm::length(q) - radius);
    return std::min(glm::distance(q, across * radius), glm::distance(q, -across * radius));
  };
  constexpr float kLeft = 0.25f, kRight = 1.25f, kLow = 0.25f, kHigh = kLetterHeight - 0.25f;
  switch (letter) {
    case 'L':
      return std::min(line({kLeft, kHigh}, {kLeft, kLow}), line({kLeft, kLow}, {kRight, kLow}));
    case 'U':
      return std::min({line({kLeft, kHigh}, {kLeft, kLow + 0.5f}),
                       line({kRight, kHigh}, {kRight, kLow + 0.5f}),
                       half_ring({0.75f, kLow + 0.5f}, {0, -1}, 0.5f)});
    case 'E':
      return std::min(
          {line({kLeft, kHigh}, {kLeft, kLow}), line({kLeft, kLow}, {kRight, kLow}),
           line({kLeft, kHigh}, {kRight, kHigh}),
           line({kLeft, 0.5f * (kLow + kHigh)}, {kRight - 0.2f, 0.5f * (kLow + kHigh)})});
    case 'R':
      return std::min({line({kLeft, kHigh}, {kLeft, kLow}), line({kLeft, kHigh}, {0.78f, kHigh}),
                       line({kLeft, kHigh - 0.88f}, {0.78f, kHigh - 0.88f}),
                       half_ring({0.78f, kHigh - 0.44f}, {1, 0}, 0.44f),
                       line({0.72f, kHigh - 0.88f}, {kRight, kLow})});
    default:
      LUEUR_CHECK(false);
      return 0.0f;
  }
}

}  // namespace

void add_skull(MeshBuilder& builder) {
  add_isosurface_of(builder, {skull, 2.0f, {-0.95f, -0.1f, -1.3f}, {0.95f, 1.95f, 1.1f}}, 46'000);
}

void add_letter(MeshBuilder& builder, char letter) {
  constexpr float kStroke = 0.24f, kHalfDepth = 0.26f, kRounding = 0.07f;
  const auto solid = [=](glm::vec3 p) {
    const glm::vec2 q(letter_strokes({p.x + 0.75f, p.y}, letter) - (kStroke - kRounding),
                      std::abs(p.z) - (kHalfDepth - kRounding));
    return glm::length(glm::max(q, 0.0f)) + std::min(std::max(q.x, q.y), 0.0f) - kRounding;
  };
  // A wanted number of triangles would not do: the large faces cross a whole layer of cells at
  // once.
  add_isosurface(builder, {solid, 1.2f, {-0.9f, -0.1f, -0.4f}, {0.9f, 2.3f, 0.4f}}, 0.058f);
}

void add_pear(MeshBuilder& builder) {
  const auto pear = [](glm::vec3 p) {
    float d = sdf::ellipsoid(p, {0, 0.50f, 0}, {0.52f, 0.50f, 0.50f});
    d = sdf::smooth_min(d, sdf::sphere(p, {0.05f, 1.08f, 0.02f}, 0.24f), 0.52f);
    d = sdf::smooth_max(d, -sdf::sphere(p, {0.07f, 1.40f, 0.03f}, 0.07f), 0.10f);
    return sdf::smooth_max(d, -sdf::sphere(p, {0, -0.05f, 0}, 0.08f), 0.10f);
  };
  add_isosurface_of(builder, {pear, 1.5f, {-0.65f, -0.1f, -0.65f}, {0.65f, 1.5f, 0.65f}}, 4'000);
}

void add_apple(MeshBuilder& builder) {
  const auto apple = [](glm::vec3 p) {
    // Five soft lobes at the lower end.
    const float lobes = 0.012f * std::cos(5.0f * std::atan2(p.z, p.x)) *
                        glm::smoothstep(0.1f, -0.4f, p.y) *
                        glm::smoothstep(0.0f, 0.2f, glm::length(glm::vec2(p.x, p.z)));
    float d = sdf::torus(p, {0, 0.02f, 0}, {0, 1, 0}, 0.17f, 0.345f);
    d = sdf::smooth_min(d, sdf::ellipsoid(p, {0, -0.06f, 0}, {0.42f, 0.36f, 0.42f}), 0.12f) - lobes;
    d = sdf::smooth_max(d, -sdf::cone(p, {0, 0.56f, 0}, {0, 0.20f, 0}, 0.16f, 0.02f), 0.16f);
    return sdf::smooth_max(d, -sdf::sphere(p, {0, -0.50f, 0}, 0.12f), 0.12f);
  };
  add_isosurface_of(builder, {apple, 2.0f, glm::vec3(-0.62f), glm::vec3(0.62f)}, 3'400);
}

void add_lemon(MeshBuilder& builder) {
  const auto lemon = [](glm::vec3 p) {
    float d = sdf::ellipsoid(p, {0, 0, 0}, {0.50f, 0.39f, 0.39f});
    d = sdf::smooth_min(d, sdf::cone(p, {0.40f, 0, 0}, {0.60f, 0.01f, 0}, 0.13f, 0.06f), 0.14f);
    return sdf::smooth_min(d, sdf::cone(p, {-0.40f, 0, 0}, {-0.54f, 0, 0}, 0.12f, 0.05f), 0.14f);
  };
  add_isosurface_of(builder, {lemon, 1.6f, {-0.75f, -0.5f, -0.5f}, {0.8f, 0.5f, 0.5f}}, 3'000);
}

}  // namespace lueur::builtin
