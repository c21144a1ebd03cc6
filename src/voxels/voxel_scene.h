// SPDX-License-Identifier: MIT
// Triangles as the voxelizers take them.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lueur/triangles.h"
#include "shading/screen.h"
#include "voxels/params.h"

namespace lueur {

// The ranges of a batch that toggle voxels, which are the closed ones, or those that may set some:
// how thick slices are is known on the device. With a vertex as the screen has it.
std::vector<RangeData> ranges_on_screen(const TriangleBatch& batch, bool shells,
                                        const glm::mat4& view_from_world, const Screen& screen);

// All of their triangles, in work for workgroups.
std::vector<Chunk> chunks_of(std::span<const RangeData> ranges);

}  // namespace lueur
