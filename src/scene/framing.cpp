// SPDX-License-Identifier: MIT
#include "scene/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <optional>
#include <string>

#include "scene/deform.h"
#include "scene/emission.h"
#include "scene/survey.h"
#include "scene/triangle_tree.h"

namespace lueur {
namespace {

using glm::vec3;

constexpr float kMargin = 1.05f;
constexpr float kAspect = 4.0f / 3.0f;
constexpr float kObjectFovRad = 0.7f;
constexpr float kInteriorFovRad = 1.05f;
constexpr float kIlluminanceLux = glm::pi<float>();

struct View {
  vec3 eye{0.0f};
  vec3 direction{0.0f, 0.0f, -1.0f};  // unit length
};

glm::quat looking_along(const vec3& direction) {
  const bool upright = std::abs(direction.y) < 0.999f;
  return glm::quatLookAt(direction, upright ? vec3(0.0f, 1.0f, 0.0f) : vec3(0.0f, 0.0f, -1.0f));
}

int32_t add_node(Scene& scene, const char* name, const vec3& position, const vec3& direction) {
  Node node;
  node.name = name;
  node.translation = position;
  node.rotation = looking_along(direction);
  scene.nodes.push_back(node);
  return static_cast<int32_t>(scene.nodes.size() - 1);
}

std::string text_of(const vec3& v) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%.4g %.4g %.4g", double{v.x}, double{v.y}, double{v.z});
  return text.data();
}

std::string text_of(float value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", double{value});
  return text.data();
}

// The nearest eye from which all corners of the box lie within the view along `direction`.
View view_of_box(const Bounds& box, const vec3& direction) {
  const glm::quat rotation = looking_along(direction);
  const float tangent_y = std::tan(kObjectFovRad * 0.5f);
  const vec3 centre = (box.min + box.max) * 0.5f;
  float distance = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const vec3 point(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                     corner & 4 ? box.max.z : box.min.z);
    // In view space, with z towards the eye.
    const vec3 p = glm::conjugate(rotation) * (point - centre);
    const float extent = std::max(std::abs(p.y), std::abs(p.x) / kAspect);
    distance = std::max(distance, p.z + kMargin * extent / tangent_y);
  }
  if (!(distance > 0.0f)) distance = 1.0f;  // nothing to see, or a single point
  return {centre - direction * distance, direction};
}

// How far one sees on average, along rays spread over a view; the open counts little, so that walls
// rather than sky fill the picture.
float free_view(const TriangleTree& tree, const View& view, float size) {
  constexpr int kColumns = 5, kRows = 3;
  constexpr float kHalfWidth = 0.6f, kHalfHeight = 0.35f, kOpenShare = 0.1f;
  const vec3 right = glm::normalize(glm::cross(view.direction, vec3(0.0f, 1.0f, 0.0f)));
  float sum = 0.0f;
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      const float s = kHalfWidth * (2.0f * static_cast<float>(x) / (kColumns - 1) - 1.0f);
      const float t = kHalfHeight * (2.0f * static_cast<float>(y) / (kRows - 1) - 1.0f);
      const auto hit =
          tree.trace(view.eye, glm::normalize(view.direction + right * s + vec3(0.0f, t, 0.0f)));
      sum += hit ? std::min(hit->distance, size) : kOpenShare * size;
    }
  }
  return sum;
}

View view_inside(const TriangleTree& tree, const Survey& place, const Bounds& box) {
  constexpr int kDirections = 16;
  constexpr float kMinClearanceShare = 0.02f;
  const vec3 extent = box.max - box.min;
  const float size = std::max(extent.x, extent.z);
  View best;
  float best_score = -1.0f;
  for (const Standpoint& point : place.standpoints) {
    // Stand free of walls where that is possible at all.
    const float crowded = point.clearance < kMinClearanceShare * size ? 0.25f : 1.0f;
    for (int i = 0; i < kDirections; ++i) {
      const float angle = glm::two_pi<float>() * static_cast<float>(i) / kDirections;
      const View view{point.eye, vec3(std::cos(angle), 0.0f, std::sin(angle))};
      // Of views about as long, prefer the one along the place.
      const float along = std::abs(extent.x >= extent.z ? view.direction.x : view.direction.z);
      const float score = crowded * (1.0f + 0.2f * along) * free_view(tree, view, size);
      if (score <= best_score) continue;
      best_score = score;
      best = view;
    }
  }
  return best;
}

// Straight before the opening, far enough for all of it to be in view.
View view_through(const Bounds& box, const vec3& open_side) {
  const vec3 half = (box.max - box.min) * 0.5f;
  const float tangent_y = std::tan(kObjectFovRad * 0.5f);
  const float width = std::abs(open_side.x) > 0.5f ? half.z : half.x;
  const float depth = std::abs(glm::dot(half, open_side));
  const float distance = depth + kMargin * std::max(half.y, width / kAspect) / tangent_y;
  return {(box.min + box.max) * 0.5f + open_side * distance, -open_side};
}

void add_camera(Scene& scene, const TriangleTree& tree, const Survey& place, const Bounds& box) {
  View view;
  const char* where = "outside";
  Camera camera;
  camera.name = "default camera";
  camera.vertical_fov_rad = kObjectFovRad;
  if (place.kind == PlaceKind::interior) {
    where = "inside";
    view = view_inside(tree, place, box);
    camera.vertical_fov_rad = kInteriorFovRad;
  } else if (place.kind == PlaceKind::open_box) {
    where = "before the open side";
    view = view_through(box, place.open_side);
  } else {
    view = view_of_box(box, glm::normalize(vec3(-0.6f, -0.35f, -1.0f)));
  }
  // Bring the near plane closer in small models.
  const float size = glm::length(box.max - box.min);
  if (size > 0.0f) camera.near_m = std::min(camera.near_m, 0.01f * size);
  camera.node = add_node(scene, "default camera", view.eye, view.direction);
  scene.cameras.push_back(camera);
  scene.warnings.push_back(std::string("no camera in the file: one stands ") + where + " at " +
                           text_of(view.eye) + " looking along " + text_of(view.direction));
}

void add_sun(Scene& scene, const Bounds& box, const vec3& to_sun, float intensity_lux) {
  Light sun;
  sun.name = "default sun";
  sun.kind = LightKind::directional;
  sun.intensity = intensity_lux;
  // The place does not matter to the light, only to those who show its node.
  const vec3 above = (box.min + box.max) * 0.5f + to_sun * glm::length(box.max - box.min);
  sun.node = add_node(scene, "default sun", above, -to_sun);
  scene.lights.push_back(sun);
  scene.warnings.push_back("no light in the file: a sun of " + text_of(sun.intensity) +
                           " lux shines from " + text_of(to_sun));
}

// The direction from which much of the floor is in the sun, lower suns first: they also reach the
// walls. Nothing if hardly any of the floor can be lit.
std::optional<vec3> way_in_for_the_sun(const TriangleTree& tree, const Survey& place) {
  constexpr int kAzimuths = 12;
  constexpr float kMinLitShare = 0.05f;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::optional<vec3> best;
  float best_score = 0.0f;
  for (const float elevation_rad : {0.87f, 1.05f, 1.2f, 1.35f}) {
    for (int i = 0; i < kAzimuths; ++i) {
      const float azimuth = glm::two_pi<float>() * (static_cast<float>(i) + 0.3f) / kAzimuths;
      const vec3 to_sun(std::cos(elevation_rad) * std::cos(azimuth), std::sin(elevation_rad),
                        std::cos(elevation_rad) * std::sin(azimuth));
      float lit = 0.0f;
      for (const Standpoint& point : place.standpoints) {
        // Start just above the floor.
        const float lift = 0.02f * (point.eye.y - point.floor_y);
        const vec3 floor(point.eye.x, point.floor_y + lift, point.eye.z);
        if (!tree.is_blocked(floor, to_sun, kInfinity)) lit += 1.0f;
      }
      const float score = lit * (glm::half_pi<float>() - elevation_rad);
      if (lit < kMinLitShare * static_cast<float>(place.standpoints.size()) || score <= best_score)
        continue;
      best_score = score;
      best = to_sun;
    }
  }
  return best;
}

// The distance to the nearest thing around, horizontally; `size` where there is nothing.
float room_around(const TriangleTree& tree, const vec3& position, float size) {
  constexpr int kDirections = 16;
  float room = size;
  for (int i = 0; i < kDirections; ++i) {
    const float angle = glm::two_pi<float>() * static_cast<float>(i) / kDirections;
    if (const auto hit = tree.trace(position, vec3(std::cos(angle), 0.0f, std::sin(angle))))
      room = std::min(room, hit->distance);
  }
  return room;
}

struct Lamp {
  vec3 position{0.0f};
  float height = 0.0f;  // above the floor
};

// Below the ceiling over `point`.
Lamp lamp_above(const TriangleTree& tree, const Standpoint& point, const Bounds& box) {
  constexpr float kHeightShare = 0.8f;
  const auto ceiling = tree.trace(point.eye, vec3(0.0f, 1.0f, 0.0f));
  const float ceiling_y = ceiling ? point.eye.y + ceiling->distance : box.max.y;
  const float height = kHeightShare * (ceiling_y - point.floor_y);
  return {vec3(point.eye.x, point.floor_y + height, point.eye.z), height};
}

// Hangs a lamp where there is much room around it, and not far from the middle.
void add_lamp(Scene& scene, const TriangleTree& tree, const Survey& place, const Bounds& box) {
  const vec3 centre = (box.min + box.max) * 0.5f;
  const float size = glm::length(box.max - box.min);
  Lamp best = lamp_above(tree, {centre, box.min.y, 0.0f}, box);
  float best_score = -std::numeric_limits<float>::max();
  for (const Standpoint& point : place.standpoints) {
    const Lamp lamp = lamp_above(tree, point, box);
    const vec3 aside = (lamp.position - centre) * vec3(1.0f, 0.0f, 1.0f);
    const float score = room_around(tree, lamp.position, size) - 0.5f * glm::length(aside);
    if (score <= best_score) continue;
    best_score = score;
    best = lamp;
  }
  Light light;
  light.name = "default lamp";
  light.intensity = kIlluminanceLux * best.height * best.height;  // E = I / d² on the floor
  light.node = add_node(scene, "default lamp", best.position, vec3(0.0f, -1.0f, 0.0f));
  scene.lights.push_back(light);
  scene.warnings.push_back("no light in the file: a lamp of " + text_of(light.intensity) +
                           " cd hangs at " + text_of(best.position));
}

void add_light(Scene& scene, const TriangleTree& tree, const Survey& place, const Bounds& box) {
  if (place.kind == PlaceKind::object) {
    // From above the camera's left shoulder.
    const glm::mat4 camera = pose(scene, 0.0f)[static_cast<size_t>(scene.cameras[0].node)];
    vec3 back = vec3(camera[2]) * vec3(1.0f, 0.0f, 1.0f);
    back = glm::length(back) > 0.0f ? glm::normalize(back) : vec3(0.0f, 0.0f, 1.0f);
    const vec3 left(-back.z, 0.0f, back.x);
    add_sun(scene, box, glm::normalize(left * 0.5f + vec3(0.0f, 1.0f, 0.0f) + back * 0.6f),
            kIlluminanceLux);
    return;
  }
  const std::optional<vec3> to_sun = way_in_for_the_sun(tree, place);
  if (place.kind == PlaceKind::interior && to_sun)
    add_sun(scene, box, *to_sun, kIlluminanceLux / to_sun->y);  // E = I cos on the floor
  else
    add_lamp(scene, tree, place, box);
}

// Why no light has to be added, as a line for the user; none if one is missing.
std::optional<std::string> other_light(const Scene& scene,
                                       const std::vector<glm::mat4>& world_from_node,
                                       const Bounds& box) {
  constexpr double kLeastShare = 0.02;
  if (scene.environment) return "no light in the file but the environment: its light is indirect";
  const glm::dvec3 size(box.max - box.min);
  const double surface = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
  if (emitted_flux(scene, world_from_node) >= kLeastShare * double{kIlluminanceLux} * surface &&
      surface > 0.0)
    return "no light in the file but surfaces that glow: their light is indirect";
  return std::nullopt;
}

}  // namespace

void complete(Scene& scene) {
  if (!scene.cameras.empty() && !scene.lights.empty()) return;
  // Look around among what is drawn at rest, skins and morph targets applied.
  const bool any_deformed =
      std::any_of(scene.instances.begin(), scene.instances.end(),
                  [&](const MeshInstance& instance) { return is_deformed(scene, instance); });
  const Scene deformed = any_deformed ? with_deformed_meshes(scene, 0.0f) : Scene{};
  const Scene& seen = any_deformed ? deformed : scene;
  const std::vector<glm::mat4> world_from_node = pose(seen, 0.0f);
  const Bounds box = bounds(seen, world_from_node, {});
  const TriangleTree tree(seen, world_from_node);
  const Survey place = survey(tree, box);
  if (scene.cameras.empty()) add_camera(scene, tree, place, box);
  if (!scene.lights.empty()) return;
  if (auto other = other_light(seen, world_from_node, box))
    scene.warnings.push_back(std::move(*other));
  else
    add_light(scene, tree, place, box);
}

}  // namespace lueur
