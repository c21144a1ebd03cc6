// SPDX-License-Identifier: MIT
#include "renderer/light_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/placed_light.h"

namespace lueur {
namespace {

constexpr uint32_t kSpotSidePx = 2048;
constexpr uint32_t kCubeSidePx = 1024;
constexpr uint32_t kDirectionalSidePx = 4096;
constexpr float kShadowNearM = 0.02f;
// A flat map spends its texels badly on a wider cone than this (half angle): 4 times as many on its
// middle as on its edge. Such a spot gets a cube.
constexpr float kWidestFlatSpotRad = 1.0f;

glm::vec3 any_perpendicular(const glm::vec3& v) {
  const glm::vec3 axis = std::abs(v.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  return glm::normalize(glm::cross(axis, v));
}

// Rows of a matrix that takes world space to clip space with reversed z and no far plane:
// x and y over w = the distance along `forward`, z = near.
glm::mat4 perspective_view(const glm::vec3& position, const glm::vec3& right, const glm::vec3& down,
                           const glm::vec3& forward, float scale, float near_m) {
  const glm::mat4 rows(glm::vec4(scale * right, -scale * glm::dot(right, position)),
                       glm::vec4(scale * down, -scale * glm::dot(down, position)),
                       glm::vec4(0, 0, 0, near_m),
                       glm::vec4(forward, -glm::dot(forward, position)));
  return glm::transpose(rows);
}

// An orthographic view that just holds the box, nearest side at depth 1.
glm::mat4 directional_view(const glm::vec3& forward, const Bounds& box, float& texel_m) {
  const glm::vec3 right = any_perpendicular(forward);
  const glm::vec3 down = glm::cross(forward, right);
  glm::vec3 low(1e30f), high(-1e30f);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                      (corner & 4) ? box.max.z : box.min.z);
    const glm::vec3 q(glm::dot(right, p), glm::dot(down, p), glm::dot(forward, p));
    low = glm::min(low, q);
    high = glm::max(high, q);
  }
  const glm::vec3 margin = 0.01f * (high - low) + glm::vec3(1e-4f);
  low -= margin;
  high += margin;
  const glm::vec3 size = high - low;
  texel_m = std::max(size.x, size.y) / static_cast<float>(kDirectionalSidePx);
  const glm::mat4 rows(glm::vec4(2.0f / size.x * right, -(low.x + high.x) / size.x),
                       glm::vec4(2.0f / size.y * down, -(low.y + high.y) / size.y),
                       glm::vec4(-1.0f / size.z * forward, high.z / size.z), glm::vec4(0, 0, 0, 1));
  return glm::transpose(rows);
}

void look_into_cone(LightView& view, float outer_cone_rad) {
  LightParams& p = view.params;
  const float half_width = std::tan(outer_cone_rad * 1.02f);
  view.shadow_side_px = kSpotSidePx;
  p.texel_m = 2.0f * half_width / static_cast<float>(kSpotSidePx);
  const glm::vec3 right = any_perpendicular(p.direction_world);
  view.clip_from_world = {perspective_view(p.position_world, right,
                                           glm::cross(p.direction_world, right), p.direction_world,
                                           1.0f / half_width, kShadowNearM)};
}

void look_all_around(LightView& view) {
  LightParams& p = view.params;
  view.shadow_side_px = kCubeSidePx;
  p.texel_m = 2.0f / static_cast<float>(kCubeSidePx);
  // Vulkan's cube faces: +x, -x, +y, -y, +z, -z, each with the directions of its u and v.
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const glm::vec3 faces[6][3] = {{-z, -y, x}, {z, -y, -x}, {x, z, y},
                                 {x, -z, -y}, {x, -y, z},  {-x, -y, -z}};
  for (const auto& face : faces)
    view.clip_from_world.push_back(
        perspective_view(p.position_world, face[0], face[1], face[2], 1.0f, kShadowNearM));
}

}  // namespace

LightView view_of_light(const Light& light, const glm::mat4& world_from_node,
                        const Bounds& scene_bounds) {
  LightView view;
  LightParams& p = view.params;
  const PlacedLight placed = place(light, world_from_node);
  p.position_world = placed.position_world;
  p.direction_world = placed.direction_world;
  p.intensity = placed.intensity;
  p.cone_scale = placed.cone_scale;
  p.cone_offset = placed.cone_offset;
  p.inverse_range = placed.inverse_range;
  p.shadow_near_m = kShadowNearM;
  switch (light.kind) {
    case LightKind::directional:
      p.kind = kLightDirectional;
      view.shadow_side_px = kDirectionalSidePx;
      view.clip_from_world = {directional_view(p.direction_world, scene_bounds, p.texel_m)};
      break;
    case LightKind::spot:
      p.kind = kLightSpot;
      if (placed.outer_cone_rad <= kWidestFlatSpotRad)
        look_into_cone(view, placed.outer_cone_rad);
      else
        look_all_around(view);
      break;
    case LightKind::point:
      p.kind = kLightPoint;
      look_all_around(view);
      break;
  }
  p.shadow_from_world = view.clip_from_world[0];
  return view;
}

}  // namespace lueur
