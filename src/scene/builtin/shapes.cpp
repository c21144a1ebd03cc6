// SPDX-License-Identifier: MIT
#include "scene/builtin/shapes.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace lueur::builtin {
namespace {

// Corner k of the face, counter-clockwise from outside, as corners of the hexahedron.
struct Face {
  unsigned bit;
  int corner[4];  // at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1)
  int axis_u, axis_v;
};
constexpr Face kFaces[6] = {
    {kNegativeX, {0, 4, 6, 2}, 2, 1}, {kPositiveX, {5, 1, 3, 7}, 2, 1},
    {kNegativeY, {0, 1, 5, 4}, 0, 2}, {kPositiveY, {2, 6, 7, 3}, 2, 0},
    {kNegativeZ, {1, 0, 2, 3}, 0, 1}, {kPositiveZ, {4, 5, 7, 6}, 0, 1},
};

}  // namespace

void add_hexahedron(MeshBuilder& builder, const std::array<glm::vec3, 8>& corners,
                    const Tessellation& tessellation, unsigned coarse_faces) {
  const int cells[3] = {tessellation.flat(glm::distance(corners[0], corners[1])),
                        tessellation.flat(glm::distance(corners[0], corners[2])),
                        tessellation.flat(glm::distance(corners[0], corners[4]))};
  for (const Face& face : kFaces) {
    const glm::vec3 a = corners[face.corner[0]], b = corners[face.corner[1]];
    const glm::vec3 c = corners[face.corner[2]], d = corners[face.corner[3]];
    const int nu = cells[face.axis_u], nv = cells[face.axis_v];
    const auto position = [=](int i, int j) {
      return mix_exact(mix_exact(a, b, i, nu), mix_exact(d, c, i, nu), j, nv);
    };
    const auto normal = [=](int i, int j) {
      const float u = float(i) / float(nu), v = float(j) / float(nv);
      return glm::normalize(glm::cross(glm::mix(b - a, c - d, v), glm::mix(d - a, c - b, u)));
    };

    // A face of few cells gains nothing from a fan.
    if ((coarse_faces & face.bit) != 0 && nu * nv * 2 > 2 * (nu + nv)) {
      const auto rim = [=](int k) {
        if (k < nu) return position(k, 0);
        if (k < nu + nv) return position(nu, k - nu);
        if (k < nu + nv + nu) return position(nu - (k - nu - nv), nv);
        return position(0, nv - (k - nu - nv - nu));
      };
      builder.add_fan((a + b + c + d) * 0.25f, 2 * (nu + nv), rim,
                      glm::normalize(glm::cross(c - a, d - b)));
      continue;
    }
    builder.add_grid(nu, nv, [=](int i, int j) {
      const glm::vec3 p = position(i, j), n = normal(i, j);
      return SurfacePoint{p, n, planar_uv(p, n)};
    });
  }
}

void add_box(MeshBuilder& builder, glm::vec3 min, glm::vec3 max, const Tessellation& tessellation,
             unsigned coarse_faces) {
  std::array<glm::vec3, 8> corners;
  for (int k = 0; k < 8; ++k)
    corners[k] = {(k & 1) ? max.x : min.x, (k & 2) ? max.y : min.y, (k & 4) ? max.z : min.z};
  add_hexahedron(builder, corners, tessellation, coarse_faces);
}

Profile& Profile::line_to(glm::vec2 end) {
  const glm::vec2 along = end - end_;
  const float length = glm::length(along);
  LUEUR_CHECK_OP(length, >, 0.0f);
  const int cells = std::max(1, int(std::lround(length / tessellation_.edge_m)));
  const glm::vec2 normal = glm::vec2(along.y, -along.x) / length;
  std::vector<Point> piece;
  for (int k = 0; k <= cells; ++k)
    piece.push_back({k == cells ? end : end_ + along * (float(k) / float(cells)), normal});
  pieces_.push_back(std::move(piece));
  end_ = end;
  return *this;
}

Profile& Profile::arc_to(glm::vec2 end, float turn_rad, int minimum_cells) {
  const glm::vec2 chord = end - end_;
  const float length = glm::length(chord);
  LUEUR_CHECK_OP(length, >, 0.0f);
  const float radius = length / (2.0f * std::sin(turn_rad / 2.0f));  // signed as the turn is
  const glm::vec2 left = glm::vec2(-chord.y, chord.x) / length;
  const glm::vec2 center = (end_ + end) * 0.5f + left * (radius * std::cos(turn_rad / 2.0f));
  const int cells = tessellation_.curved(std::abs(radius * turn_rad), minimum_cells);
  std::vector<Point> piece;
  for (int k = 0; k <= cells; ++k) {
    const float angle = turn_rad * float(k) / float(cells);
    const glm::vec2 spoke = (end_ - center);
    const glm::vec2 turned{spoke.x * std::cos(angle) - spoke.y * std::sin(angle),
                           spoke.x * std::sin(angle) + spoke.y * std::cos(angle)};
    const glm::vec2 position = k == 0 ? end_ : k == cells ? end : center + turned;
    piece.push_back({position, glm::normalize(turned / radius)});
  }
  pieces_.push_back(std::move(piece));
  end_ = end;
  return *this;
}

float Profile::max_x() const {
  float result = 0.0f;
  for (const auto& piece : pieces_)
    for (const Point& point : piece) result = std::max(result, point.position.x);
  return result;
}

void add_lathe(MeshBuilder& builder, const Profile& profile, int cells_around) {
  const float around_m = 2.0f * kPi * profile.max_x();
  float travelled_m = 0.0f;
  for (const auto& piece : profile.pieces()) {
    const int cells = int(piece.size()) - 1;
    std::vector<float> along_m{travelled_m};
    for (int k = 1; k <= cells; ++k)
      along_m.push_back(along_m.back() + glm::distance(piece[k - 1].position, piece[k].position));
    travelled_m = along_m.back();
    builder.add_grid(cells_around, cells,
                     [&](int i, int j) {
                       const glm::vec2 c = unit_circle_point(i, cells_around);
                       const Profile::Point& p = piece[j];
                       const float u = around_m * float(i) / float(cells_around);
                       return SurfacePoint{{p.position.x * c.x, p.position.y, -p.position.x * c.y},
                                           {p.normal.x * c.x, p.normal.y, -p.normal.x * c.y},
                                           {u, -along_m[j]}};
                     },
                     {piece.front().position.x == 0.0f, piece.back().position.x == 0.0f});
  }
}

void add_sweep(MeshBuilder& builder, const Profile& profile, glm::vec2 cap_center, int cells,
               const std::function<SweepFrame(int k)>& frame_at) {
  std::vector<SweepFrame> frames;
  for (int k = 0; k <= cells; ++k) frames.push_back(frame_at(k));
  std::vector<float> path_m{0.0f};
  for (int k = 1; k <= cells; ++k)
    path_m.push_back(path_m.back() + glm::distance(frames[k - 1].origin, frames[k].origin));
  const auto place = [&](int k, glm::vec2 p) {
    return frames[k].origin + frames[k].out * p.x + frames[k].up * p.y;
  };

  // Draw each smooth piece of the profile along the whole path.
  float travelled_m = 0.0f;
  for (const auto& piece : profile.pieces()) {
    std::vector<float> along_m{travelled_m};
    for (size_t k = 1; k < piece.size(); ++k)
      along_m.push_back(along_m.back() + glm::distance(piece[k - 1].position, piece[k].position));
    travelled_m = along_m.back();
    builder.add_grid(cells, int(piece.size()) - 1, [&](int i, int j) {
      const Profile::Point& p = piece[j];
      return SurfacePoint{place(i, p.position),
                          frames[i].out * p.normal.x + frames[i].up * p.normal.y,
                          {path_m[i], -along_m[j]}};
    });
  }

  // Close both ends over the profile's outline.
  std::vector<glm::vec2> rim;
  for (const auto& piece : profile.pieces())
    for (size_t k = 0; k + 1 < piece.size(); ++k) rim.push_back(piece[k].position);
  const int count = int(rim.size());
  const auto along = [&](int k) { return glm::cross(frames[k].up, frames[k].out); };
  builder.add_fan(
      place(0, cap_center), count, [&](int k) { return place(0, rim[k]); }, -along(0));
  builder.add_fan(
      place(cells, cap_center), count, [&](int k) { return place(cells, rim[count - 1 - k]); },
      along(cells));
}

void add_moulding(MeshBuilder& builder, const Profile& profile, glm::vec2 cap_center,
                  glm::vec3 start, glm::vec3 end, glm::vec3 out, const Tessellation& tessellation) {
  LUEUR_CHECK(glm::dot(glm::cross(glm::vec3(0, 1, 0), out), end - start) > 0.0f);
  const int cells = tessellation.flat(glm::distance(start, end));
  add_sweep(builder, profile, cap_center, cells, [&](int k) {
    return SweepFrame{mix_exact(start, end, k, cells), out, {0, 1, 0}};
  });
}

}  // namespace lueur::builtin
