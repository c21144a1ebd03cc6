// SPDX-License-Identifier: MIT
// Small scenes of quads for tests, and each pixel's ray to hold closed forms against a picture.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

namespace lueur {

// A scene with one camera (on node 0), a white rough material (0), and nothing in it.
Scene scene_seen_from(const glm::vec3& eye, const glm::vec3& target);
// A parallelogram with its own node; its front side is where cross(u, v) points. UV runs from 0 to
// 1 along u and v. Returns the node.
int32_t add_quad(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                 int32_t material = 0);
// A horizontal square around the origin that faces up.
int32_t add_floor(Scene& scene, float half_side, int32_t material = 0);
// A light at `position` that shines along `direction`.
Light& add_light(Scene& scene, LightKind kind, float intensity, const glm::vec3& position,
                 const glm::vec3& direction = {0, -1, 0});

// What a test asks of one pixel.
struct PixelRay {
  uint32_t x = 0, y = 0;
  size_t index = 0;      // of the pixel, rows from the top
  glm::dvec3 origin;     // world
  glm::dvec3 direction;  // world, not unit: it advances by 1 along the optical axis
};

// One ray for each pixel's centre, row by row.
std::vector<PixelRay> pixel_rays(const Camera& camera, const glm::dmat4& world_from_camera,
                                 uint32_t width, uint32_t height);

// Where the ray meets the plane through `point`; none if behind the camera or along the plane.
std::optional<glm::dvec3> meet_plane(const PixelRay& ray, const glm::dvec3& point,
                                     const glm::dvec3& normal);

}  // namespace lueur
