// SPDX-License-Identifier: MIT
#include <glm/gtc/type_ptr.hpp>

#include "frame/screen_of_view.h"
#include "techniques/hierarchical/hierarchical_frame.h"
#include "techniques/hierarchical/shaders.h"
#include "voxels/voxel_grid.h"

namespace lueur::hierarchical {

std::string at_level(const std::string& pass, uint32_t level) {
  return "hierarchical." + pass + "@" + std::to_string(level);
}

Pyramid HierarchicalFrame::begin_pyramid(const View& view, const GBuffer& g, const Beginning& how) {
  const glm::mat4 view_from_world = glm::make_mat4(view.view_from_world.data());
  Pyramid pyramid;
  pyramid.g_buffer = g;
  pyramid.screen = screen_of_view(view, g.depth.extent);
  pyramid.view_from_world = view_from_world;
  pyramid.world_from_view = glm::inverse(view_from_world);
  pyramid.factor = how.factor;
  pyramid.is_dark = !how.source.valid();

  const auto step = static_cast<uint32_t>(how.factor);
  Level level;
  level.extent = {divide_up(g.depth.extent.width, step), divide_up(g.depth.extent.height, step)};
  level.screen = pyramid.screen;
  level.screen.ray_scale *= static_cast<float>(step);
  if (how.keeps_history) {
    geometry_history_ = frame_.history("hierarchical.geometry", level.extent, Format::rgba32f);
    level.geometry = geometry_history_.current;
  } else {
    level.geometry = frame_.image("geometry", level.extent, Format::rgba32f);
  }
  level.source = frame_.image("source", level.extent, Format::rgba16f);
  frame_.dispatch(at_level("pyramid", 0),
                  {.shader = shaders::techniques_hierarchical_prepare_comp,
                   .constants = {{"factor", step}, {"by_vote", by_vote()}},
                   .params = PrepareParams{pyramid.screen, mat3(view_from_world),
                                           as_ivec2(g.depth.extent), as_ivec2(level.extent)},
                   .read = {{"depth", g.depth},
                            {"normal", g.normal},
                            {"source", pyramid.is_dark ? g.source : how.source}},
                   .write = {{"geometry_out", level.geometry}, {"source_out", level.source}},
                   .over = level.extent});
  pyramid.levels.push_back(level);
  return pyramid;
}

void HierarchicalFrame::finish_pyramid(Pyramid& pyramid, uint32_t levels) {
  for (uint32_t k = 1; k < levels; ++k) {
    const Level& fine = pyramid.levels.back();
    Level level;
    level.extent = {divide_up(fine.extent.width, 2), divide_up(fine.extent.height, 2)};
    level.screen = fine.screen;
    level.screen.ray_scale *= 2.0f;
    level.geometry = frame_.image("geometry", level.extent, Format::rgba32f);
    level.source = frame_.image("source", level.extent, Format::rgba16f);
    frame_.dispatch(at_level("pyramid", k),
                    {.shader = shaders::techniques_hierarchical_downsample_comp,
                     .constants = {{"by_vote", by_vote()}},
                     .params = DownsampleParams{level.screen, fine.screen.ray_scale,
                                                as_ivec2(fine.extent), as_ivec2(level.extent)},
                     .read = {{"geometry", fine.geometry}, {"source", fine.source}},
                     .write = {{"geometry_out", level.geometry}, {"source_out", level.source}},
                     .over = level.extent});
    pyramid.levels.push_back(level);
  }
}

// FDP 4, "visibility computation".
void HierarchicalFrame::voxelize(Pyramid& pyramid) {
  const VoxelGrid grid =
      lueur::voxelize(frame_, {.triangles = inputs_.host->triangles(public_frame_),
                               .view_from_world = pyramid.view_from_world,
                               .screen = pyramid.finest().screen,
                               .geometry = pyramid.finest().geometry,
                               .slices = 32u << static_cast<uint32_t>(settings_.voxel_slices),
                               .levels = static_cast<uint32_t>(pyramid.levels.size()),
                               .voxelizer = settings_.voxelizer == Settings::Voxelizer::raster
                                                ? Voxelizer::raster
                                                : Voxelizer::compute});
  if (frame_.failed()) return;
  for (size_t k = 0; k < pyramid.levels.size(); ++k) pyramid.levels[k].voxels = grid.levels[k];
  pyramid.voxel_range = grid.range;
}

uint32_t HierarchicalFrame::by_vote() const {
  return settings_.pyramid == Settings::Pyramid::vote ? 1 : 0;
}

Image HierarchicalFrame::albedo(const Pyramid& pyramid) {
  const Extent extent = pyramid.finest().extent;
  const Image mean = frame_.image("mean", extent, Format::rgba16f);
  frame_.dispatch(
      "hierarchical.albedo",
      {.shader = shaders::techniques_hierarchical_albedo_comp,
       .constants = {{"factor", static_cast<uint32_t>(pyramid.factor)}},
       .params = AlbedoParams{as_ivec2(pyramid.g_buffer.albedo.extent), as_ivec2(extent)},
       .read = {{"albedo", pyramid.g_buffer.albedo}},
       .write = {{"mean", mean}},
       .over = extent});
  return mean;
}

// albedo * light as source of level 0, on top of the pyramid's own or alone.
Image HierarchicalFrame::reflect(const Pyramid& pyramid, Image albedo, Image light, bool on_top) {
  const Level& finest = pyramid.finest();
  const Image source = frame_.image("source", finest.extent, Format::rgba16f);
  frame_.dispatch("hierarchical.reflect",
                  {.shader = shaders::techniques_hierarchical_reflect_comp,
                   .params = ReflectParams{as_ivec2(finest.extent), on_top ? 1.0f : 0.0f},
                   .read = {{"source", finest.source}, {"albedo", albedo}, {"light", light}},
                   .write = {{"source_out", source}},
                   .over = finest.extent});
  return source;
}

Pyramid HierarchicalFrame::with_source(const Pyramid& pyramid, Image source) {
  Pyramid other = pyramid;
  other.levels[0].source = source;
  for (uint32_t k = 1; k < other.levels.size(); ++k) {
    const Level& fine = other.levels[k - 1];
    Level& level = other.levels[k];
    const Image before = level.source;
    level.source = frame_.image("source", level.extent, Format::rgba16f);
    frame_.dispatch(
        at_level("source", k),
        {.shader = shaders::techniques_hierarchical_downsample_source_comp,
         .params = DownsampleSourceParams{as_ivec2(fine.extent), as_ivec2(level.extent)},
         .read = {{"source", fine.source}, {"foreshortened", before}},
         .write = {{"source_out", level.source}},
         .over = level.extent});
  }
  return other;
}

void HierarchicalFrame::release_sources(const Pyramid& pyramid) {
  for (const Level& level : pyramid.levels) frame_.release(level.source);
}

void HierarchicalFrame::release(const Pyramid& pyramid) {
  release_sources(pyramid);
  for (const Level& level : pyramid.levels) frame_.release(level.voxels);
  for (const Level& level : pyramid.levels)
    if (level.geometry.index != geometry_history_.current.index) frame_.release(level.geometry);
}

}  // namespace lueur::hierarchical
