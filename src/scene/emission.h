// SPDX-License-Identifier: MIT
// How much light a scene's surfaces emit.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace lueur {

// Luminous flux in lumen of all surfaces, of one side of each: pi * luminance * area, with
// textures' means.
double emitted_flux(const Scene& scene, const std::vector<glm::mat4>& world_from_node);

}  // namespace lueur
