// SPDX-License-Identifier: MIT
// Closed solids for the built-in scenes. Everything here adds a watertight piece to a MeshBuilder,
// unless a comment says that the caller closes it.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "scene/builtin/mesh_builder.h"

namespace lueur::builtin {

// The six faces of a box, as bits. A coarse face is cut as a fan over its rim: for faces that
// nobody sees, which then cost few triangles but still match their neighbours.
enum FaceBits : unsigned {
  kNegativeX = 1,
  kPositiveX = 2,
  kNegativeY = 4,
  kPositiveY = 8,
  kNegativeZ = 16,
  kPositiveZ = 32,
};

// Corner k lies at the maximum of x, y, z where bit 0, 1, 2 of k is set, before the solid is
// skewed.
void add_hexahedron(MeshBuilder& builder, const std::array<glm::vec3, 8>& corners,
                    const Tessellation& tessellation, unsigned coarse_faces = 0);
void add_box(MeshBuilder& builder, glm::vec3 min, glm::vec3 max, const Tessellation& tessellation,
             unsigned coarse_faces = 0);

// Texture coordinates (metres) of a place on a piece that looks to the unit vector `out`.
using FaceUv = std::function<glm::vec2(glm::vec3 position, glm::vec3 out)>;

// A box with its edges and corners cut off `bevel_m` deep: 44 triangles. The faces are flat and the
// normals turn over the bevels, so that they look round.
void add_bevelled_box(MeshBuilder& builder, glm::vec3 min, glm::vec3 max, float bevel_m,
                      const FaceUv& uv_m = planar_uv);

// A line in the plane with (x outwards, y upwards): outside is to its right. It is made of pieces
// that are smooth in themselves and meet at hard edges.
class Profile {
 public:
  struct Point {
    glm::vec2 position;
    glm::vec2 normal;  // unit length, outwards
  };

  Profile(glm::vec2 start, const Tessellation& tessellation)
      : tessellation_(tessellation), end_(start) {}

  // A straight piece. Tessellated along its length only if it is longer than an edge.
  Profile& line_to(glm::vec2 end);
  // A circular arc that turns by `turn_rad`: > 0 bulges outwards, < 0 is hollow; |turn| < 2π.
  Profile& arc_to(glm::vec2 end, float turn_rad, int minimum_cells = 1);

  const std::vector<std::vector<Point>>& pieces() const { return pieces_; }
  float max_x() const;

 private:
  Tessellation tessellation_;
  glm::vec2 end_;
  std::vector<std::vector<Point>> pieces_;
};

// Turns `profile` around the y axis. Closed if the profile starts and ends at x = 0.
void add_lathe(MeshBuilder& builder, const Profile& profile, int cells_around);

// A plate of `thickness_m` about the xy plane with this closed outline (counter-clockwise) and
// round edges of radius `bevel_m`; `center` must see the whole outline.
void add_plate(MeshBuilder& builder, const Profile& outline, glm::vec2 center, float thickness_m,
               float bevel_m);

// Where a swept profile's plane lies: its x axis, y axis and origin. The path must run along
// cross(up, out).
struct SweepFrame {
  glm::vec3 origin;
  glm::vec3 out;
  glm::vec3 up;
};

// Moves a closed profile (counter-clockwise) through `cells + 1` frames and caps both ends;
// `cap_center` must see the whole profile.
void add_sweep(MeshBuilder& builder, const Profile& profile, glm::vec2 cap_center, int cells,
               const std::function<SweepFrame(int k)>& frame_at);

// A straight moulding from `start` to `end` (horizontal): profile x points to `out`.
void add_moulding(MeshBuilder& builder, const Profile& profile, glm::vec2 cap_center,
                  glm::vec3 start, glm::vec3 end, glm::vec3 out, const Tessellation& tessellation);

// A sphere whose radius is scaled by `scale(direction)`, for things that are nearly round.
void add_sphere(MeshBuilder& builder, glm::vec3 center, float radius_m, int cells_around,
                const std::function<float(glm::vec3 direction)>& scale = {});

// A round tube along the closed curve `curve(t)`, t in [0, 1].
void add_closed_tube(MeshBuilder& builder, const std::function<glm::vec3(float t)>& curve,
                     float radius_m, int cells_along, int cells_around);

// A round rod through `points` that is `radius_m[k]` thick at each but the last, where it ends in a
// point; its other end is flat.
void add_tapered_tube(MeshBuilder& builder, const std::vector<glm::vec3>& points,
                      const std::vector<float>& radius_m, int cells_around);

// A sheet of cloth: `middle(u, v)` is its middle surface, u to the right and v down as seen from
// its front; `size_m` its size in metres.
void add_cloth(MeshBuilder& builder, const std::function<glm::vec3(float u, float v)>& middle,
               glm::vec2 size_m, float thickness_m, int cells_u, int cells_v);

}  // namespace lueur::builtin
