// SPDX-License-Identifier: MIT
// Where a light looks from: the views of its shadow maps.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/params.h"
#include "scene/scene.h"

namespace lueur {

// One light of one frame.
struct LightView {
  LightParams params{};  // without screen, world_from_view and extent
  uint32_t shadow_side_px = 0;
  std::vector<glm::mat4> clip_from_world;  // one, or six faces in the order of a Vulkan cube map
};

// `scene_bounds` is what a directional light's map has to cover.
LightView view_of_light(const Light& light, const glm::mat4& world_from_node,
                        const Bounds& scene_bounds);

}  // namespace lueur
