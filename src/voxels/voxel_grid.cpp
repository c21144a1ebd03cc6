// SPDX-License-Identifier: MIT
#include "voxels/voxel_grid.h"

#include <algorithm>
#include <string>

#include "base/check.h"
#include "voxels/shaders.h"
#include "voxels/slices.h"
#include "voxels/voxel_scene.h"

namespace lueur {
namespace {

constexpr uint32_t kWordSlices = 32;
constexpr uint32_t kTargetSlices = 4 * kWordSlices;  // of a target of the raster voxelizer
constexpr uint32_t kMaxTargets = 4;
constexpr uint32_t kMaxGroupsInARow = 32'768;  // devices allow 65'535 at least

// What the passes of one grid have in common.
struct Pass {
  Recorder& frame;
  const VoxelizeInfo& info;
  Extent extent;   // of level 0, pixels
  uint32_t words;  // a column
  BufferRef range{};

  Image level_image(Extent level) const {
    return frame.image("voxels", {level.width, level.height * words}, Format::r32ui);
  }
  BufferRef find_range() const;
  Image compute() const;
  void toggle(Image voxels, bool shells) const;
  Image raster() const;
  void draw(const std::string& pass, const TriangleBatch& batch, bool shells,
            std::span<const DrawTarget> targets) const;
  Image coarser(Image fine, Extent fine_extent, Extent level_extent, uint32_t level) const;
};

// From where to where something is visible.
BufferRef Pass::find_range() const {
  const Extent threads{extent.width, divide_up(extent.height, kRowsPerThread)};
  const uint32_t count = divide_up(threads.width, 64) * threads.height;
  const BufferRef parts = frame.buffer("parts", count * sizeof(vec2));
  const BufferRef found = frame.buffer("range", sizeof(VoxelRange));
  frame.dispatch("voxels.range_part", {.shader = shaders::voxels_range_part_comp,
                                       .params = RangePartParams{as_ivec2(extent)},
                                       .read = {{"geometry", info.geometry}},
                                       .write = {{"parts", parts}},
                                       .over = threads});
  frame.dispatch("voxels.range", {.shader = shaders::voxels_range_comp,
                                  .params = RangeParams{count, info.slices},
                                  .read = {{"parts", parts}},
                                  .write = {{"range", found}},
                                  .over = {1, 1}});
  return found;
}

void Pass::toggle(Image voxels, bool shells) const {
  for (const TriangleBatch& batch : info.triangles) {
    const std::vector<RangeData> ranges =
        ranges_on_screen(batch, shells, info.view_from_world, info.screen);
    const std::vector<Chunk> chunks = chunks_of(ranges);
    if (chunks.empty()) continue;
    const auto count = static_cast<uint32_t>(chunks.size());
    const uint32_t in_a_row = std::min(count, kMaxGroupsInARow);
    frame.dispatch(
        shells ? "voxels.shell" : "voxels.solid",
        {.shader = shaders::voxels_toggle_comp,
         .constants = {{"shell", shells}},
         .params = ToggleParams{as_ivec2(extent), {batch.first_float, batch.stride_floats}, count},
         .read = {{"vertices", batch.vertices},
                  {"indices", batch.indices},
                  {"ranges", frame.upload(ranges)},
                  {"chunks", frame.upload(chunks)},
                  {"range", range}},
         .write = {{"voxels", voxels}},
         .over = {in_a_row * kChunkTriangles, divide_up(count, in_a_row)}});
  }
}

Image Pass::compute() const {
  const Image voxels = level_image(extent);
  frame.dispatch(
      "voxels.clear",
      {.shader = shaders::voxels_clear_comp, .write = {{"voxels", voxels}}, .over = voxels.extent});
  toggle(voxels, false);
  frame.dispatch("voxels.fill", {.shader = shaders::voxels_fill_comp,
                                 .params = FillParams{as_ivec2(extent), words},
                                 .write = {{"voxels", voxels}},
                                 .over = extent});
  toggle(voxels, true);
  return voxels;
}

// The first draw clears the targets, the others draw onto what it left.
void Pass::draw(const std::string& pass, const TriangleBatch& batch, bool shells,
                std::span<const DrawTarget> targets) const {
  const std::vector<RangeData> ranges =
      ranges_on_screen(batch, shells, info.view_from_world, info.screen);
  if (ranges.empty() && targets[0].keep) return;
  frame.draw(pass,
             {.state = {.vertex = &shaders::voxels_raster_vert,
                        .fragment = &shaders::voxels_raster_frag,
                        .logic_op = shells ? gpu::LogicOp::bit_or : gpu::LogicOp::bit_xor},
              .params = RasterParams{as_ivec2(extent), {batch.first_float, batch.stride_floats}},
              .read = {{"vertices", batch.vertices}, {"indices", batch.indices}, {"range", range}},
              .color = {targets.begin(), targets.end()},
              .record = [&](DrawList& list) {
                list.cull_back_faces(false);
                for (const RangeData& data : ranges) {
                  list.push(RasterDraw{data, shells});
                  list.vertices(3 * data.triangle_count);
                }
              }});
}

// FDP section 4: "blending is done with a XOR [...] stored in 4 render targets of 32bit each", here
// channels of targets.
Image Pass::raster() const {
  std::vector<DrawTarget> targets;
  for (uint32_t i = 0; i < divide_up(info.slices, kTargetSlices); ++i) {
    static constexpr const char* kNames[kMaxTargets] = {"bits_0", "bits_1", "bits_2", "bits_3"};
    targets.push_back(
        {.name = kNames[i], .image = frame.image(kNames[i], extent, Format::rgba32ui)});
  }
  for (const bool shells : {false, true})
    for (const TriangleBatch& batch : info.triangles) {
      draw(shells ? "voxels.shell" : "voxels.solid", batch, shells, targets);
      for (DrawTarget& target : targets) target.keep = true;
    }

  const Image voxels = level_image(extent);
  const auto bits = [&](size_t i) { return targets[std::min(i, targets.size() - 1)].image; };
  frame.dispatch(
      "voxels.copy",
      {.shader = shaders::voxels_raster_copy_comp,
       .params = RasterCopyParams{as_ivec2(extent), words},
       .read = {{"bits_0", bits(0)}, {"bits_1", bits(1)}, {"bits_2", bits(2)}, {"bits_3", bits(3)}},
       .write = {{"voxels", voxels}},
       .over = extent});
  for (const DrawTarget& target : targets) frame.release(target.image);
  return voxels;
}

Image Pass::coarser(Image fine, Extent fine_extent, Extent level_extent, uint32_t level) const {
  const Image voxels = level_image(level_extent);
  frame.dispatch("voxels.level@" + std::to_string(level),
                 {.shader = shaders::voxels_level_comp,
                  .params = LevelParams{as_ivec2(fine_extent), as_ivec2(level_extent), words},
                  .read = {{"fine", fine}},
                  .write = {{"voxels", voxels}},
                  .over = voxels.extent});
  return voxels;
}

}  // namespace

VoxelGrid voxelize(Recorder& frame, const VoxelizeInfo& info) {
  if (frame.failed()) return {};
  LUEUR_CHECK(info.slices == 32 || info.slices == 64 || info.slices == 128 || info.slices == 256 ||
              info.slices == 512);
  LUEUR_CHECK(info.levels >= 1);
  const Extent extent = info.geometry.extent;
  const uint32_t words = info.slices / kWordSlices;
  const uint32_t limit = frame.device().properties.limits.maxImageDimension2D;
  if (extent.height * words > limit)
    frame.fail({ErrorKind::usage, std::to_string(info.slices) + " slices of voxels at " +
                                      std::to_string(extent.width) + "x" +
                                      std::to_string(extent.height) + " need an image " +
                                      std::to_string(extent.height * words) +
                                      " pixels high, the device allows " + std::to_string(limit) +
                                      "; use fewer slices or a coarser start level"});
  if (info.voxelizer == Voxelizer::raster && !frame.has_logic_op())
    frame.fail(
        {ErrorKind::usage,
         "the raster voxelizer needs the device feature logicOp; use the compute voxelizer"});
  if (frame.failed()) return {};

  Pass pass{frame, info, extent, words};
  pass.range = pass.find_range();
  VoxelGrid grid;
  grid.slices = info.slices;
  grid.range = pass.range;
  grid.extents.push_back(extent);
  // Without triangles there is nothing to draw with.
  grid.levels.push_back(info.voxelizer == Voxelizer::raster && !info.triangles.empty()
                            ? pass.raster()
                            : pass.compute());
  while (grid.levels.size() < info.levels) {
    const Extent fine = grid.extents.back();
    const Extent level{divide_up(fine.width, 2), divide_up(fine.height, 2)};
    grid.levels.push_back(
        pass.coarser(grid.levels.back(), fine, level, static_cast<uint32_t>(grid.levels.size())));
    grid.extents.push_back(level);
  }
  return grid;
}

}  // namespace lueur
