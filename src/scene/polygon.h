// SPDX-License-Identifier: MIT
// Polygons in space cut into triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lueur {

// Twice the area, along the normal from which the corners go round counter-clockwise; of a polygon
// that is not flat, the mean over its corners (Newell).
glm::dvec3 area_vector(std::span<const glm::vec3> corners);

// Adds triangles that cover the polygon, as indices of its corners and with its winding. Right for
// every simple polygon, concave ones too, and for holes that a double edge joins to the outline.
// False when it finds no clean cut, as the outline crosses itself: the rest of it is cut somehow.
// Corners without extent may be left out, so that fewer than n - 2 triangles come.
bool triangulate(std::span<const glm::vec3> corners, std::vector<uint32_t>& triangles);

}  // namespace lueur
