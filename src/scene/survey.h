// SPDX-License-Identifier: MIT
// What kind of place a scene is, found by looking around in it: an object to walk around, or rooms
// to stand in.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "scene/triangle_tree.h"

namespace lueur {

enum class PlaceKind : uint8_t {
  object,    // seen from outside
  open_box,  // a room that lacks one wall, as Cornell boxes do: seen through the missing wall
  interior,  // seen from inside
};

// A point at eye height above a floor.
struct Standpoint {
  glm::vec3 eye{0.0f};
  float floor_y = 0.0f;
  float clearance = 0.0f;  // to the nearest thing around, horizontally
};

struct Survey {
  PlaceKind kind = PlaceKind::object;
  glm::vec3 open_side{0.0f};            // out of the missing wall; open_box only
  std::vector<Standpoint> standpoints;  // enclosed by walls; empty for objects
  bool under_open_sky = false;          // of all standpoints: the interior is a courtyard
};

Survey survey(const TriangleTree& tree, const Bounds& box);

}  // namespace lueur
