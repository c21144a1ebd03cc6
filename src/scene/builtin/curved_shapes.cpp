// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "scene/builtin/shapes.h"

namespace lueur::builtin {

void add_sphere(MeshBuilder& builder, glm::vec3 center, float radius_m, int cells_around,
                const std::function<float(glm::vec3 direction)>& scale) {
  const int cells_down = std::max(2, cells_around / 2);
  const auto direction_at = [=](float turn, float down) {
    const float s = std::sin(kPi * down);
    return glm::vec3(s * std::cos(2 * kPi * turn), std::cos(kPi * down),
                     s * std::sin(2 * kPi * turn));
  };
  const auto position_at = [&](glm::vec3 direction) {
    return center + direction * (radius_m * (scale ? scale(direction) : 1.0f));
  };
  builder.add_grid(
      cells_around, cells_down,
      [&](int i, int j) {
        // The poles and the seam repeat their points exactly.
        const float turn = float(i % cells_around) / float(cells_around);
        glm::vec3 direction = direction_at(turn, float(j) / float(cells_down));
        if (j == 0) direction = {0, 1, 0};
        if (j == cells_down) direction = {0, -1, 0};
        glm::vec3 normal = direction;
        if (scale) {
          // Tilt the normal by the slope of the radius, taken along two directions.
          const glm::vec3 t = glm::normalize(glm::cross(
              std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), direction));
          const glm::vec3 b = glm::cross(direction, t);
          const float h = 0.01f;
          const auto step = [&](glm::vec3 by) {
            return position_at(glm::normalize(direction + by));
          };
          normal = glm::cross(step(t * h) - step(t * -h), step(b * h) - step(b * -h));
        }
        return SurfacePoint{position_at(direction),
                            normal,
                            {-2 * kPi * radius_m * float(i) / float(cells_around),
                             kPi * radius_m * float(j) / float(cells_down)}};
      },
      {true, true});
}

void add_closed_tube(MeshBuilder& builder, const std::function<glm::vec3(float t)>& curve,
                     float radius_m, int cells_along, int cells_around) {
  // Frames by the curve's own bend (Frenet), which close by themselves on a closed curve.
  std::vector<glm::vec3> center, axis_a, axis_b;
  std::vector<float> along_m;
  for (int i = 0; i <= cells_along; ++i) {
    const float t = float(i % cells_along) / float(cells_along), h = 0.002f;
    const glm::vec3 p = curve(t), before = curve(t - h), after = curve(t + h);
    const glm::vec3 along = glm::normalize(after - before);
    const glm::vec3 bend = after + before - 2.0f * p;
    center.push_back(p);
    axis_a.push_back(glm::normalize(bend - along * glm::dot(bend, along)));
    axis_b.push_back(glm::cross(along, axis_a.back()));
    along_m.push_back(i == 0 ? 0.0f : along_m.back() + glm::distance(center[i - 1], p));
  }
  builder.add_grid(cells_along, cells_around, [&](int i, int j) {
    const glm::vec2 c = unit_circle_point(j, cells_around);
    const glm::vec3 normal = axis_a[i] * c.x - axis_b[i] * c.y;
    return SurfacePoint{center[i] + normal * radius_m,
                        normal,
                        {along_m[i], -2 * kPi * radius_m * float(j) / float(cells_around)}};
  });
}

void add_tapered_tube(MeshBuilder& builder, const std::vector<glm::vec3>& points,
                      const std::vector<float>& radius_m, int cells_around) {
  const int rings = int(points.size()) - 1;
  LUEUR_CHECK_OP(rings, >, 0);
  LUEUR_CHECK_OP(radius_m.size(), >=, size_t(rings));

  // Carry a frame along the points that turns no more than they do.
  std::vector<glm::vec3> along, axis_a, axis_b;
  std::vector<float> along_m{0.0f};
  for (int k = 0; k <= rings; ++k) {
    along.push_back(glm::normalize(points[std::min(k + 1, rings)] - points[std::max(k - 1, 0)]));
    const glm::vec3 before =
        k > 0 ? axis_a.back()
              : (std::abs(along[0].y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    axis_a.push_back(glm::normalize(before - along[k] * glm::dot(before, along[k])));
    axis_b.push_back(glm::cross(along[k], axis_a[k]));
    if (k > 0) along_m.push_back(along_m.back() + glm::distance(points[k - 1], points[k]));
  }
  const auto outwards = [&](int i, int k) {
    const glm::vec2 c = unit_circle_point(i, cells_around);
    return axis_a[k] * c.x + axis_b[k] * c.y;
  };
  const auto rim = [&](int i, int k) { return points[k] + outwards(i, k) * radius_m[k]; };
  builder.add_grid(cells_around, rings,
                   [&](int i, int k) {
                     const float u = 2 * kPi * radius_m[0] * float(i) / float(cells_around);
                     if (k == rings) return SurfacePoint{points[k], along[k], {u, -along_m[k]}};
                     return SurfacePoint{rim(i, k), outwards(i, k), {u, -along_m[k]}};
                   },
                   {false, true});
  builder.add_fan(
      points[0], cells_around, [&](int i) { return rim(cells_around - i, 0); }, -along[0]);
}

void add_cloth(MeshBuilder& builder, const std::function<glm::vec3(float u, float v)>& middle,
               glm::vec2 size_m, float thickness_m, int cells_u, int cells_v) {
  // Sample the middle surface once; both sides and the hems share it.
  struct Sample {
    glm::vec3 front, back, normal;
    glm::vec2 uv_m;
  };
  std::vector<Sample> samples;
  for (int j = 0; j <= cells_v && !builder.counts_only(); ++j) {
    for (int i = 0; i <= cells_u; ++i) {
      // Take normals over neighbours, not over the function: its folds may be finer than the grid.
      const auto sample = [&](int column, int row) {
        return middle(float(std::clamp(column, 0, cells_u)) / float(cells_u),
                      float(std::clamp(row, 0, cells_v)) / float(cells_v));
      };
      const glm::vec3 along_u = sample(i + 1, j) - sample(i - 1, j);
      const glm::vec3 along_v = sample(i, j + 1) - sample(i, j - 1);
      const glm::vec3 normal = glm::normalize(glm::cross(along_v, along_u));
      const glm::vec3 position = sample(i, j), half = normal * (thickness_m * 0.5f);
      const glm::vec2 uv_m =
          size_m * glm::vec2(float(i) / float(cells_u), float(j) / float(cells_v));
      samples.push_back({position + half, position - half, normal, uv_m});
    }
  }
  const auto at = [&](int i, int j) -> const Sample& { return samples[j * (cells_u + 1) + i]; };

  builder.add_grid(cells_u, cells_v, [&](int i, int j) {
    const Sample& s = at(i, cells_v - j);
    return SurfacePoint{s.front, s.normal, s.uv_m};
  });
  builder.add_grid(cells_u, cells_v, [&](int i, int j) {
    const Sample& s = at(i, j);
    return SurfacePoint{s.back, -s.normal, {-s.uv_m.x, s.uv_m.y}};
  });

  // Sew the sides together along the four hems.
  const auto hem = [&](const Sample& s, bool front, glm::vec3 normal) {
    return SurfacePoint{front ? s.front : s.back, normal,
                        s.uv_m + glm::vec2(front ? 0.0f : thickness_m)};
  };
  for (const bool left : {true, false}) {
    builder.add_grid(1, cells_v, [&](int i, int j) {
      const int column = left ? 0 : cells_u;
      const Sample& s = at(column, cells_v - j);
      const Sample& inner = at(left ? 1 : cells_u - 1, cells_v - j);
      const glm::vec3 out = s.front - inner.front;
      return hem(s, (i == 1) == left, out - s.normal * glm::dot(out, s.normal));
    });
  }
  for (const bool top : {true, false}) {
    builder.add_grid(cells_u, 1, [&](int i, int j) {
      const int row = top ? 0 : cells_v;
      const Sample& s = at(i, row);
      const Sample& inner = at(i, top ? 1 : cells_v - 1);
      const glm::vec3 out = s.front - inner.front;
      return hem(s, (j == 0) == top, out - s.normal * glm::dot(out, s.normal));
    });
  }
}

}  // namespace lueur::builtin
