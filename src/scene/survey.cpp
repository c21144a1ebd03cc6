// SPDX-License-Identifier: MIT
#include "scene/survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace lueur {
namespace {

using glm::vec3;

constexpr float kRoomMinSizeM = 2.0f;     // what is smaller is not a room
constexpr float kRoomMaxHeightM = 60.0f;  // what is higher is not in metres
constexpr float kEyeHeightM = 1.6f;
constexpr float kEyeHeightShare = 0.35f;  // of the height, where metres say nothing

float eye_height(const Bounds& box) {
  const float height = box.max.y - box.min.y;
  const bool in_metres = height >= kRoomMinSizeM && height <= kRoomMaxHeightM;
  return in_metres ? std::min(kEyeHeightM, kEyeHeightShare * height) : kEyeHeightShare * height;
}

// Whether what was hit is a wall seen from inside: its front, or, in something as large as a room,
// a sheet without a back.
bool faces_inwards(const std::optional<TriangleTree::Hit>& hit, const Bounds& box) {
  const vec3 size = box.max - box.min;
  const bool room_sized = std::min({size.x, size.y, size.z}) >= kRoomMinSizeM;
  return hit && (hit->front || (hit->double_sided && room_sized));
}

// The share of rays from above the middle to one side of the box that end at a wall.
float wall_share(const TriangleTree& tree, const Bounds& box, const vec3& side) {
  constexpr int kRays = 5;
  const vec3 centre = (box.min + box.max) * 0.5f;
  const vec3 half = (box.max - box.min) * 0.5f;
  const vec3 origin = centre + vec3(0.0f, 0.5f * half.y, 0.0f);  // above most furniture
  const vec3 across(side.z, 0.0f, side.x);
  int walls = 0;
  for (int y = 0; y < kRays; ++y) {
    for (int x = 0; x < kRays; ++x) {
      const float s = 0.8f * (2.0f * static_cast<float>(x) / (kRays - 1) - 1.0f);
      const float t = 0.8f * (2.0f * static_cast<float>(y) / (kRays - 1) - 1.0f);
      const vec3 target = centre + half * (side + across * s + vec3(0.0f, t, 0.0f));
      walls += faces_inwards(tree.trace(origin, target - origin), box) ? 1 : 0;
    }
  }
  return static_cast<float>(walls) / (kRays * kRays);
}

// The side whose wall is missing while the three others are there.
std::optional<vec3> missing_wall(const TriangleTree& tree, const Bounds& box) {
  constexpr float kMissing = 0.2f, kPresent = 0.8f;
  std::optional<vec3> missing;
  int present = 0;
  for (const vec3& side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
    const float share = wall_share(tree, box, side);
    if (share >= kPresent) ++present;
    if (share <= kMissing) missing = side;
  }
  return present == 3 ? missing : std::nullopt;
}

// Looks around at eye height above the floor below `start`; nothing if there is no floor, or no
// walls around.
std::optional<Standpoint> enclosed_standpoint(const TriangleTree& tree, const Bounds& box,
                                              const vec3& start) {
  constexpr int kDirections = 32;
  constexpr float kEnclosed = 0.85f;
  const auto floor = tree.trace(start, vec3(0.0f, -1.0f, 0.0f));
  if (!faces_inwards(floor, box)) return std::nullopt;
  Standpoint point;
  point.floor_y = start.y - floor->distance;
  point.eye = vec3(start.x, point.floor_y + eye_height(box), start.z);
  point.clearance = std::numeric_limits<float>::max();
  int walls = 0;
  for (int i = 0; i < kDirections; ++i) {
    const float angle = glm::two_pi<float>() * (static_cast<float>(i) + 0.5f) / kDirections;
    const float rise = 0.15f * static_cast<float>(i % 3 - 1);
    const auto hit =
        tree.trace(point.eye, glm::normalize(vec3(std::cos(angle), rise, std::sin(angle))));
    if (!faces_inwards(hit, box)) continue;
    ++walls;
    point.clearance = std::min(point.clearance, hit->distance);
  }
  if (static_cast<float>(walls) < kEnclosed * kDirections) return std::nullopt;
  return point;
}

constexpr int kGrid = 11;
constexpr float kInteriorShare = 0.2f;  // of a grid of places

std::vector<Standpoint> standpoints_below(const TriangleTree& tree, const Bounds& box,
                                          float height_share) {
  std::vector<Standpoint> points;
  const vec3 size = box.max - box.min;
  for (int z = 0; z < kGrid; ++z) {
    for (int x = 0; x < kGrid; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / kGrid;
      const float v = (static_cast<float>(z) + 0.5f) / kGrid;
      const vec3 start = box.min + size * vec3(u, height_share, v);
      if (const auto point = enclosed_standpoint(tree, box, start)) points.push_back(*point);
    }
  }
  return points;
}

// In a courtyard, keeps only the places under the open sky: that is where one sees and the sun
// comes in, and not the passages around it.
void keep_open_sky(const TriangleTree& tree, Survey& place) {
  constexpr float kCourtyardShare = 0.03f;
  std::vector<Standpoint> open;
  for (const Standpoint& point : place.standpoints)
    if (!tree.trace(point.eye, vec3(0.0f, 1.0f, 0.0f))) open.push_back(point);
  if (static_cast<float>(open.size()) < kCourtyardShare * kGrid * kGrid) return;
  place.under_open_sky = true;
  place.standpoints = std::move(open);
}

}  // namespace

Survey survey(const TriangleTree& tree, const Bounds& box) {
  Survey result;
  if (const std::optional<vec3> side = missing_wall(tree, box)) {
    result.kind = PlaceKind::open_box;
    result.open_side = *side;
  }

  // Look for the lowest floor on which one can stand in enough places: what is looked for from
  // higher up may be a gallery, a hanging or the top of a cupboard.
  for (const float height_share : {0.25f, 0.5f, 0.75f}) {
    result.standpoints = standpoints_below(tree, box, height_share);
    if (static_cast<float>(result.standpoints.size()) < kInteriorShare * kGrid * kGrid) continue;
    if (result.kind == PlaceKind::open_box) return result;
    result.kind = PlaceKind::interior;
    keep_open_sky(tree, result);
    return result;
  }
  result.standpoints.clear();
  return result;
}

}  // namespace lueur
