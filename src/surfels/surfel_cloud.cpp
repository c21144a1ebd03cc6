// SPDX-License-Identifier: MIT
#include "surfels/surfel_cloud.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <vector>

#include "frame/device_list.h"
#include "surfels/params.h"
#include "surfels/shaders.h"

namespace lueur {
namespace {

// A workgroup each, as many in a row as every device takes.
constexpr uint32_t kMostInARow = 32768;

std::vector<SurfelRange> ranges_of(const TriangleBatch& batch, const glm::mat4& view_from_world) {
  std::vector<SurfelRange> ranges;
  for (const TriangleRange& range : batch.ranges)
    ranges.push_back({view_from_world * glm::make_mat4(range.world_from_object.data()),
                      range.first_index, range.vertex_offset, range.index_count / 3});
  return ranges;
}

std::vector<SurfelChunk> chunks_of(const std::vector<SurfelRange>& ranges) {
  std::vector<SurfelChunk> chunks;
  for (uint32_t i = 0; i < ranges.size(); ++i)
    for (uint32_t first = 0; first < ranges[i].triangle_count; first += kSurfelChunk)
      chunks.push_back({i, first});
  return chunks;
}

}  // namespace

SurfelCloud surfelize(Recorder& frame, const SurfelizeInfo& info) {
  const SurfelCloud cloud{
      device_list(frame, "surfels.begin", "surfels", info.surfels_capacity, sizeof(Surfel)),
      info.surfels_capacity};
  SurfelizeParams params{};
  params.screen = info.screen;
  params.corner_px = vec2(info.extent.width, info.extent.height);
  params.pixel = std::sqrt(std::abs(info.screen.ray_scale.x * info.screen.ray_scale.y));
  params.radius_px = info.radius_px;
  params.margin_m = info.margin_m;
  params.least_distance_m = info.least_distance_m;
  params.parts_capacity = info.parts_capacity;
  params.surfels_capacity = info.surfels_capacity;
  for (const TriangleBatch& batch : info.triangles) {
    const std::vector<SurfelRange> ranges = ranges_of(batch, info.view_from_world);
    const std::vector<SurfelChunk> chunks = chunks_of(ranges);
    if (chunks.empty() || frame.failed()) continue;
    params.first_float = batch.first_float;
    params.stride_floats = batch.stride_floats;
    params.chunks = static_cast<uint32_t>(chunks.size());
    const BufferRef range_data = frame.upload(ranges);
    const BufferRef parts = device_list(frame, "surfels.begin_parts", "parts", info.parts_capacity,
                                        sizeof(TrianglePart));
    frame.dispatch("surfels.split", {.shader = shaders::surfels_split_comp,
                                     .params = params,
                                     .read = {{"vertices", batch.vertices},
                                              {"indices", batch.indices},
                                              {"ranges", range_data},
                                              {"chunks", frame.upload(chunks)}},
                                     .write = {{"list", parts}},
                                     .over = {kSurfelChunk * std::min(params.chunks, kMostInARow),
                                              divide_up(params.chunks, kMostInARow)}});
    frame.dispatch("surfels.place", {.shader = shaders::surfels_place_comp,
                                     .params = params,
                                     .read = {{"vertices", batch.vertices},
                                              {"indices", batch.indices},
                                              {"ranges", range_data},
                                              {"parts", parts}},
                                     .write = {{"list", cloud.list}},
                                     .groups = groups_of_list(frame, "surfels.end_parts", parts,
                                                              info.parts_capacity, kSurfelChunk)});
  }
  return cloud;
}

}  // namespace lueur
