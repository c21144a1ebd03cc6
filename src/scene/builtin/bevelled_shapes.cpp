// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {
namespace {

// A flat patch with its corners at (0, 0), (1, 0), (1, 1), (0, 1) and a normal at each.
struct Patch {
  glm::vec3 corner[4];
  glm::vec3 normal[4];
};

// Adds `patch` so that it looks to `out`, whichever way round it was given. With `triangle` its
// first corner is twice there and makes no area.
void add_patch(MeshBuilder& builder, const Patch& patch, glm::vec3 out, const FaceUv& uv_m,
               bool triangle = false) {
  const glm::vec3 facing =
      glm::cross(patch.corner[2] - patch.corner[0], patch.corner[3] - patch.corner[1]);
  const bool flip = glm::dot(facing, out) < 0.0f;
  constexpr int kAt[2][2] = {{0, 1}, {3, 2}};
  builder.add_grid(
      1, 1,
      [&](int i, int j) {
        const int k = kAt[j][flip ? 1 - i : i];
        return SurfacePoint{patch.corner[k], patch.normal[k], uv_m(patch.corner[k], out)};
      },
      {triangle, false});
}

}  // namespace

void add_bevelled_box(MeshBuilder& builder, glm::vec3 min, glm::vec3 max, float bevel_m,
                      const FaceUv& uv_m) {
  const glm::vec3 middle = 0.5f * (min + max), half = 0.5f * (max - min);
  LUEUR_CHECK_OP(bevel_m, <, std::min({half.x, half.y, half.z}));
  const auto axis = [](int a, float sign) {
    glm::vec3 n(0.0f);
    n[a] = sign;
    return n;
  };

  // Corner `sign` of the face across axis `a`: a bevel inside of the box's own corner.
  const auto corner = [&](glm::vec3 sign, int a) {
    glm::vec3 reach = half - bevel_m;
    reach[a] = half[a];
    return middle + sign * reach;
  };
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    for (const float s : {-1.0f, 1.0f}) {
      const auto at = [&](float sb, float sc) {
        return corner(axis(a, s) + axis(b, sb) + axis(c, sc), a);
      };
      const glm::vec3 n = axis(a, s);
      add_patch(builder, {{at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}, {n, n, n, n}}, n, uv_m);

      // The bevel between this face and the one across axis b, along axis c.
      for (const float t : {-1.0f, 1.0f}) {
        const glm::vec3 near = axis(a, s) + axis(b, t) - axis(c, 1), m = axis(b, t);
        const glm::vec3 far = near + 2.0f * axis(c, 1);
        add_patch(
            builder,
            {{corner(near, a), corner(far, a), corner(far, b), corner(near, b)}, {n, n, m, m}},
            glm::normalize(n + m), uv_m);
      }
    }
  }
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 sign((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
    const glm::vec3 x = corner(sign, 0), y = corner(sign, 1), z = corner(sign, 2);
    const glm::vec3 nx = axis(0, sign.x), ny = axis(1, sign.y), nz = axis(2, sign.z);
    add_patch(builder, {{x, x, y, z}, {nx, nx, ny, nz}}, glm::normalize(sign), uv_m, true);
  }
}

void add_plate(MeshBuilder& builder, const Profile& outline, glm::vec2 center, float thickness_m,
               float bevel_m) {
  constexpr int kBevelCells = 2;
  LUEUR_CHECK_OP(2.0f * bevel_m, <, thickness_m);
  const auto& pieces = outline.pieces();

  // Where each point moves when the outline shrinks by one metre; at a corner, both sides' way.
  std::vector<std::vector<glm::vec2>> inwards(pieces.size());
  for (size_t piece = 0; piece < pieces.size(); ++piece) {
    const auto& points = pieces[piece];
    for (size_t k = 0; k < points.size(); ++k) {
      glm::vec2 beside = points[k].normal;
      if (k == 0) beside = pieces[(piece + pieces.size() - 1) % pieces.size()].back().normal;
      if (k + 1 == points.size()) beside = pieces[(piece + 1) % pieces.size()].front().normal;
      inwards[piece].push_back(-(points[k].normal + beside) /
                               (1.0f + glm::dot(points[k].normal, beside)));
    }
  }

  // Row j of the rim, from the back's edge to the front's.
  const auto angle_at = [](int j) {
    const int step = j <= kBevelCells ? kBevelCells - j : j - kBevelCells - 1;
    return 0.5f * kPi * float(step) / float(kBevelCells);
  };
  const auto position = [&](size_t piece, size_t k, int j) {
    const float side = j <= kBevelCells ? -1.0f : 1.0f, angle = angle_at(j);
    const glm::vec2 p =
        pieces[piece][k].position + inwards[piece][k] * (bevel_m * (1.0f - std::cos(angle)));
    return glm::vec3(p, side * (0.5f * thickness_m - bevel_m * (1.0f - std::sin(angle))));
  };
  constexpr int kRows = 2 * kBevelCells + 1;
  std::vector<glm::vec3> front, back;
  float travelled_m = 0.0f;
  for (size_t piece = 0; piece < pieces.size(); ++piece) {
    const auto& points = pieces[piece];
    std::vector<float> along_m{travelled_m};
    for (size_t k = 1; k < points.size(); ++k)
      along_m.push_back(along_m.back() + glm::distance(points[k - 1].position, points[k].position));
    travelled_m = along_m.back();
    builder.add_grid(int(points.size()) - 1, kRows, [&](int i, int j) {
      const glm::vec3 p = position(piece, size_t(i), j);
      const float side = j <= kBevelCells ? -1.0f : 1.0f, angle = angle_at(j);
      return SurfacePoint{p,
                          glm::vec3(points[i].normal * std::cos(angle), side * std::sin(angle)),
                          {along_m[i], -p.z}};
    });
    for (size_t k = 0; k + 1 < points.size(); ++k) {
      back.push_back(position(piece, k, 0));
      front.push_back(position(piece, k, kRows));
    }
  }
  const int count = int(front.size());
  builder.add_fan({center, 0.5f * thickness_m}, count, [&](int k) { return front[k]; }, {0, 0, 1});
  builder.add_fan({center, -0.5f * thickness_m}, count, [&](int k) { return back[count - 1 - k]; },
                  {0, 0, -1});
}

}  // namespace lueur::builtin
