// SPDX-License-Identifier: MIT
#include "scene/builtin/arcade.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace lueur::builtin {
namespace {

// A stretch of the wall: a pier, or an arch with the wall above it. `lower` is where the wall above
// the springing begins at each cut, from left to right.
struct Stretch {
  const ArchOpening* arch;  // null for a pier
  std::vector<glm::vec2> lower;
};

std::vector<Stretch> cut_into_stretches(const ArcadeWall& wall, const Tessellation& tessellation) {
  std::vector<Stretch> stretches;
  float x = wall.x0;
  const auto add_pier = [&](float end) {
    LUEUR_CHECK_OP(end, >, x);
    const int cells = tessellation.flat(end - x);
    Stretch stretch{nullptr, {}};
    for (int k = 0; k <= cells; ++k)
      stretch.lower.emplace_back(k == cells ? end : x + (end - x) * float(k) / float(cells),
                                 wall.springing);
    stretches.push_back(std::move(stretch));
    x = end;
  };
  for (const ArchOpening& arch : wall.openings) {
    add_pier(arch.center_x - arch.radius_m);
    const int cells = tessellation.curved(kPi * arch.radius_m, 4);
    Stretch stretch{&arch, {}};
    for (int k = 0; k <= cells; ++k) {
      const float angle = kPi * float(cells - k) / float(cells);
      stretch.lower.emplace_back(arch.center_x + arch.radius_m * std::cos(angle),
                                 wall.springing + arch.radius_m * std::sin(angle));
    }
    stretch.lower.front() = {arch.center_x - arch.radius_m, wall.springing};
    stretch.lower.back() = {arch.center_x + arch.radius_m, wall.springing};
    stretches.push_back(std::move(stretch));
    x = arch.center_x + arch.radius_m;
  }
  add_pier(wall.x1);
  return stretches;
}

// Adds flat faces between the wall's two z planes; all share the wall's cuts.
class WallFaces {
 public:
  WallFaces(MeshBuilder& builder, const ArcadeWall& wall, const Tessellation& tessellation)
      : builder_(builder), wall_(wall), cells_deep_(tessellation.flat(wall.z1 - wall.z0)) {}

  // Front and back between the lines `low` and `high`, which have the same x.
  void add_front_and_back(const std::vector<glm::vec2>& low, const std::vector<glm::vec2>& high,
                          int cells_up) {
    const int cells = int(low.size()) - 1;
    for (const bool front : {true, false}) {
      const glm::vec3 normal{0, 0, front ? 1 : -1};
      builder_.add_grid(cells, cells_up, [&](int i, int j) {
        const int k = front ? i : cells - i;
        const float z = front ? wall_.z1 : wall_.z0;
        const glm::vec3 p = mix_exact(glm::vec3(low[k], z), glm::vec3(high[k], z), j, cells_up);
        return SurfacePoint{p, normal, planar_uv(p, normal)};
      });
    }
  }

  // A horizontal face along `line` that looks up or down.
  void add_level(const std::vector<glm::vec2>& line, bool up) {
    const glm::vec3 normal{0, up ? 1 : -1, 0};
    builder_.add_grid(int(line.size()) - 1, cells_deep_, [&](int i, int j) {
      const glm::vec3 p = across(line[i], up ? cells_deep_ - j : j);
      return SurfacePoint{p, normal, planar_uv(p, normal)};
    });
  }

  // The underside of an arch.
  void add_soffit(const Stretch& stretch) {
    const glm::vec2 center{stretch.arch->center_x, wall_.springing};
    const int cells = int(stretch.lower.size()) - 1;
    const float cell_m = kPi * stretch.arch->radius_m / float(cells);
    builder_.add_grid(cells, cells_deep_, [&](int i, int j) {
      const glm::vec3 p = across(stretch.lower[i], j);
      const glm::vec3 normal(center - stretch.lower[i], 0);
      return SurfacePoint{p, normal, {cell_m * float(i), -p.z}};
    });
  }

  // An upright face across the wall at `x` from y0 to y1 that looks to -x or +x.
  void add_jamb(float x, float y0, float y1, int cells_up, bool left) {
    const glm::vec3 normal{left ? -1 : 1, 0, 0};
    builder_.add_grid(cells_deep_, cells_up, [&](int i, int j) {
      const float y = mix_exact({0, y0, 0}, {0, y1, 0}, j, cells_up).y;
      const glm::vec3 p = across({x, y}, left ? i : cells_deep_ - i);
      return SurfacePoint{p, normal, planar_uv(p, normal)};
    });
  }

 private:
  glm::vec3 across(glm::vec2 p, int k) const {
    return mix_exact(glm::vec3(p, wall_.z0), glm::vec3(p, wall_.z1), k, cells_deep_);
  }

  MeshBuilder& builder_;
  const ArcadeWall& wall_;
  int cells_deep_;
};

std::vector<glm::vec2> at_height(std::vector<glm::vec2> line, float y) {
  for (glm::vec2& p : line) p.y = y;
  return line;
}

}  // namespace

void add_arcade_wall(MeshBuilder& builder, const ArcadeWall& wall,
                     const Tessellation& tessellation) {
  LUEUR_CHECK_OP(wall.bottom, <=, wall.springing);
  const bool has_piers = wall.bottom < wall.springing;
  const int cells_upper = tessellation.flat(wall.top - wall.springing);
  const int cells_pier = tessellation.flat(wall.springing - wall.bottom);
  WallFaces faces(builder, wall, tessellation);
  for (const Stretch& stretch : cut_into_stretches(wall, tessellation)) {
    const std::vector<glm::vec2> top = at_height(stretch.lower, wall.top);
    faces.add_front_and_back(stretch.lower, top, cells_upper);
    faces.add_level(top, true);
    if (stretch.arch) {
      faces.add_soffit(stretch);
      continue;
    }
    const std::vector<glm::vec2> bottom = at_height(stretch.lower, wall.bottom);
    faces.add_level(bottom, false);
    if (!has_piers) continue;
    faces.add_front_and_back(bottom, stretch.lower, cells_pier);
    faces.add_jamb(bottom.front().x, wall.bottom, wall.springing, cells_pier, true);
    faces.add_jamb(bottom.back().x, wall.bottom, wall.springing, cells_pier, false);
  }
  faces.add_jamb(wall.x0, wall.springing, wall.top, cells_upper, true);
  faces.add_jamb(wall.x1, wall.springing, wall.top, cells_upper, false);
}

void add_archivolts(MeshBuilder& builder, const ArcadeWall& wall,
                    const Tessellation& tessellation) {
  if (!tessellation.shows(0.2f)) return;
  for (const ArchOpening& arch : wall.openings) {
    // Let the band stand into the opening by a finger, so that it never lies in the soffit.
    const float inner = arch.radius_m - 0.02f, outer = arch.radius_m + 0.2f;
    Profile profile({-0.03f, inner}, tessellation);
    profile.line_to({0.05f, inner})
        .line_to({0.05f, outer - 0.07f})
        .arc_to({-0.03f, outer}, 1.2f, 1)
        .line_to({-0.03f, inner});
    const int cells = tessellation.curved(kPi * arch.radius_m, 4);
    add_sweep(builder, profile, {0.01f, 0.5f * (inner + outer) - 0.03f}, cells, [&](int k) {
      const float angle = kPi * float(cells - k) / float(cells);
      return SweepFrame{{arch.center_x, wall.springing, wall.z1},
                        {0, 0, 1},
                        {std::cos(angle), std::sin(angle), 0}};
    });
  }
}

}  // namespace lueur::builtin
