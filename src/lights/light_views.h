// SPDX-License-Identifier: MIT
// The views that a light has: what it shines on is what they see.
#pragma once

#include <vector>

#include "lueur/host.h"
#include "lueur/view.h"

namespace lueur {

// Square views, with reversed z and an infinitely far plane, in the order of a Vulkan cube map
// where they are its faces:
//   spot          one, around its cone; a cone wider than 120 degrees gets those faces of a cube,
//                 turned to look along it, that it reaches
//   point         six faces
//   directional   one, from so far away that its rays are parallel to 0.02 rad, around the box
// Each direction, or point of the box, is in exactly one of them but for the views' edges.
std::vector<View> views_of_light(const PunctualLight& light, const Box& bounds);

}  // namespace lueur
