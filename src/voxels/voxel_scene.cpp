// SPDX-License-Identifier: MIT
#include "voxels/voxel_scene.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

namespace lueur {

namespace {

// 0 of what bounds nothing, and the greatest number of what is thick enough.
float thickness_in_world(const TriangleRange& range) {
  if (!range.closed) return 0.0f;
  if (range.thickness <= 0.0f) return std::numeric_limits<float>::max();
  const glm::mat3 turn_and_scale(glm::make_mat4(range.world_from_object.data()));
  return range.thickness * std::cbrt(std::abs(glm::determinant(turn_and_scale)));
}

}  // namespace

std::vector<RangeData> ranges_on_screen(const TriangleBatch& batch, bool shells,
                                        const glm::mat4& view_from_world, const Screen& screen) {
  std::vector<RangeData> ranges;
  for (const TriangleRange& range : batch.ranges) {
    const float thickness_m = thickness_in_world(range);
    const bool may_be_thin = thickness_m < std::numeric_limits<float>::max();
    if (!(shells ? may_be_thin : range.closed) || range.index_count == 0) continue;
    // In double precision: far from the origin, what is seen is a small difference of large terms.
    const glm::dmat4 view_from_object =
        glm::dmat4(view_from_world) * glm::dmat4(glm::make_mat4(range.world_from_object.data()));
    const auto row = [&](int i) {
      return glm::dvec4(view_from_object[0][i], view_from_object[1][i], view_from_object[2][i],
                        view_from_object[3][i]);
    };
    // Of the ray (x, y, -1) z through pixel position (ray - ray_offset) / ray_scale.
    const glm::dvec4 z = -row(2);
    RangeData data{};
    data.row_x = (row(0) - z * double{screen.ray_offset.x}) / double{screen.ray_scale.x};
    data.row_y = (row(1) - z * double{screen.ray_offset.y}) / double{screen.ray_scale.y};
    data.row_z = z;
    data.first_index = range.first_index;
    data.vertex_offset = range.vertex_offset;
    data.triangle_count = range.index_count / 3;
    data.thickness_m = thickness_m;
    ranges.push_back(data);
  }
  return ranges;
}

std::vector<Chunk> chunks_of(std::span<const RangeData> ranges) {
  std::vector<Chunk> chunks;
  for (uint32_t i = 0; i < ranges.size(); ++i)
    for (uint32_t first = 0; first < ranges[i].triangle_count; first += kChunkTriangles)
      chunks.push_back({i, first});
  return chunks;
}

}  // namespace lueur
