// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "scene/builtin/room_parts.h"

namespace lueur::builtin {
namespace {

// Places along one edge of the cube [-1, 1]³ and how far each lies beyond the flat part.
struct Stop {
  float flat;  // position on the inner box
  float bend;  // -1 … 1: share of the bevel's turn towards the neighbouring face
};

std::vector<Stop> stops(float low, float high, int flat_cells, int bevel_cells) {
  std::vector<Stop> result;
  for (int k = 0; k <= bevel_cells; ++k)
    result.push_back({low, -1.0f + float(k) / float(bevel_cells)});
  for (int k = 1; k < flat_cells; ++k)
    result.push_back({low + (high - low) * (float(k) / float(flat_cells)), 0.0f});
  for (int k = 0; k <= bevel_cells; ++k) result.push_back({high, float(k) / float(bevel_cells)});
  return result;
}

}  // namespace

void add_rounded_box(MeshBuilder& builder, glm::vec3 min, glm::vec3 max, float bevel_m,
                     const Tessellation& tessellation) {
  LUEUR_CHECK(glm::all(glm::greaterThan(max - min, glm::vec3(2.0f * bevel_m))));
  constexpr int kBevelCells = 3;
  const glm::vec3 low = min + bevel_m, high = max - bevel_m;
  std::vector<Stop> along[3];
  for (int axis = 0; axis < 3; ++axis)
    along[axis] =
        stops(low[axis], high[axis], tessellation.flat(high[axis] - low[axis]), kBevelCells);

  // Each face is the cube's, pushed out from the inner box: the directions of two faces agree on
  // the edge that they share, as the tangent of an eighth turn there is 1.
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool positive : {false, true}) {
      const int u = (axis + (positive ? 1 : 2)) % 3, v = (axis + (positive ? 2 : 1)) % 3;
      const auto& us = along[u];
      const auto& vs = along[v];
      builder.add_grid(int(us.size()) - 1, int(vs.size()) - 1, [&](int i, int j) {
        glm::vec3 inner, direction;
        inner[axis] = positive ? high[axis] : low[axis];
        inner[u] = us[i].flat;
        inner[v] = vs[j].flat;
        const auto lean = [](float bend) {
          return std::abs(bend) == 1.0f ? bend : std::tan(bend * 0.25f * kPi);
        };
        direction[axis] = positive ? 1.0f : -1.0f;
        direction[u] = lean(us[i].bend);
        direction[v] = lean(vs[j].bend);
        glm::vec3 face(0.0f);
        face[axis] = direction[axis];
        direction = glm::normalize(direction);
        const glm::vec3 position = inner + direction * bevel_m;
        return SurfacePoint{position, direction, planar_uv(position, face)};
      });
    }
  }
}

}  // namespace lueur::builtin
