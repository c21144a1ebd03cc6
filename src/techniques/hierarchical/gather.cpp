// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>

#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/hierarchical_frame.h"
#include "techniques/hierarchical/shaders.h"
#include "techniques/joint_filter.h"
#include "techniques/shaders.h"

namespace lueur::hierarchical {

Extent corners_of(Extent coarse) {
  return {coarse.width + 1, coarse.height + 1};
}

// A CPU wants much work in each thread (8 pixels took 0.90 of the time of 4), but still several
// workgroups to share out. With rays to march, one pixel is best: 0.7 of the time of 8, and fewer
// rounds, see check_rounds().
uint32_t HierarchicalFrame::gather_pixels_per_thread(Extent level, bool marches) const {
  constexpr uint32_t kRowsWorthIt = 16;
  return frame_.runs_on_cpu() && !marches && level.height >= kRowsWorthIt ? 8 : 1;
}

// Mesa's software rasterizer ends all loops of a thread after so many rounds, those of inner loops
// counted with them, and tells nobody: what was not gathered by then is missing.
void HierarchicalFrame::check_rounds(const GatherParams& params, uint32_t rays) {
  constexpr uint64_t kMostRounds = 65535;
  const uint64_t rounds =
      uint64_t{params.samples} * (1 + uint64_t{rays} * static_cast<uint32_t>(params.march_steps));
  if (!frame_.runs_on_cpu() || rounds < kMostRounds) return;
  frame_.fail(
      {ErrorKind::usage,
       "a CPU device loses light with visibility_steps=" + std::to_string(params.march_steps) +
           " and the " + std::to_string(params.samples) + " samples of level " +
           std::to_string(params.level) +
           ": a thread's loops end after 65535 rounds; lower visibility_steps, samples or "
           "sample_growth"});
}

uint32_t HierarchicalFrame::voxel_level(uint32_t level) const {
  return level - std::min(level, static_cast<uint32_t>(settings_.visibility_finer));
}

// Of `samples` on the level's ring; 0: every pixel.
GatherParams HierarchicalFrame::gather_params(const Level& level, uint32_t index,
                                              uint32_t samples) const {
  const float pixels_per_sample =
      samples == 0 ? 1.0f : ring_area_px(index, settings_.radius) / static_cast<float>(samples);
  GatherParams params{};
  params.screen = level.screen;
  params.extent = as_ivec2(level.extent);
  params.source_extent = as_ivec2(level.extent);
  params.inner_px = ring_inner_px(index, settings_.radius);
  params.outer_px = settings_.radius;
  params.area_over_pi = pixels_per_sample *
                        std::abs(level.screen.ray_scale.x * level.screen.ray_scale.y) /
                        std::numbers::pi_v<float>;
  params.samples = samples;
  params.level = index;
  params.seed = inputs_.seed;
  params.rotate = settings_.rotate;
  params.march_steps = settings_.visibility_steps;
  params.march_scale = static_cast<float>(1u << (index - voxel_level(index)));
  return params;
}

// Equation (4) over the level's ring. `blocked`: obstacles count, if there are voxels.
Image HierarchicalFrame::gather(const Pyramid& pyramid, uint32_t index, bool blocked) {
  const Level& level = pyramid.levels[index];
  blocked = blocked && pyramid.voxel_range.valid();
  const bool every_pixel = settings_.sampling == Settings::Sampling::every_pixel;
  const GatherParams params =
      gather_params(level, index, every_pixel ? 0 : samples_at_level(settings_, index));
  const Image indirect = frame_.image("indirect", level.extent, Format::rgba16f);
  const uint32_t pixels_per_thread =
      every_pixel ? 1 : gather_pixels_per_thread(level.extent, blocked);
  const gpu::ShaderCode& shader = every_pixel ? shaders::techniques_hierarchical_gather_all_comp
                                  : blocked   ? shaders::techniques_hierarchical_gather_visible_comp
                                              : shaders::techniques_hierarchical_gather_comp;
  Dispatch dispatch{
      .shader = shader,
      .constants = {{"form_factor", static_cast<uint32_t>(settings_.form_factor)}},
      .params = params,
      .read = {{"geometry", level.geometry}, {"source", level.source}},
      .write = {{"indirect", indirect}},
      .over = {level.extent.width,
               // Rows in groups of 3 a thread, see gather.glsl.
               every_pixel ? level.extent.height
                           : 3 * divide_up(level.extent.height, 3 * pixels_per_thread)}};
  if (!every_pixel) dispatch.constants.push_back({"pixels_per_thread", pixels_per_thread});
  if (!every_pixel && blocked) {
    check_rounds(params, 1);
    dispatch.read.push_back({"voxels", pyramid.levels[voxel_level(index)].voxels});
    dispatch.read.push_back({"range", pyramid.voxel_range});
  }
  frame_.dispatch(at_level("gather", index), dispatch);
  return indirect;
}

Image HierarchicalFrame::filter(const Level& level, uint32_t index, const std::string& kind,
                                Image light) {
  if (!settings_.filter) return light;
  const Image filtered = frame_.image("filtered", level.extent, Format::rgba16f);
  frame_.dispatch(at_level(kind + "filter", index),
                  {.shader = shaders::techniques_joint_filter_comp,
                   .params = FilterParams{level.screen, as_ivec2(level.extent), 1},
                   .read = {{"geometry", level.geometry}, {"light", light}},
                   .write = {{"filtered", filtered}},
                   .over = level.extent});
  frame_.release(light);
  return filtered;
}

// `own` invalid: the fine level has gathered nothing.
Image HierarchicalFrame::combine(const Level& fine, uint32_t index, const Level& coarse,
                                 const std::string& kind, Image own, Image light) {
  const Image combined = frame_.image("combined", fine.extent, Format::rgba16f);
  frame_.dispatch(
      at_level(kind + "combine", index),
      {.shader = shaders::techniques_hierarchical_combine_comp,
       .constants = {{"factor", 2}},
       .params = UpsampleParams{fine.screen, coarse.screen.ray_scale, as_ivec2(fine.extent),
                                as_ivec2(coarse.extent), own.valid() ? 1.0f : 0.0f},
       .read = {{"geometry", coarse.geometry},
                {"light", light},
                {"fine_geometry", fine.geometry},
                {"own", own.valid() ? own : light}},
       .write = {{"combined", combined}},
       .over = corners_of(coarse.extent)});
  frame_.release(light);
  frame_.release(own);
  return combined;
}

// From coarse to fine, adding each level to what came up from below.
Gathered HierarchicalFrame::gather_levels(
    const Pyramid& pyramid, const std::string& kind,
    const std::function<Image(const Level&, uint32_t)>& gather_level) {
  const std::vector<Level>& levels = pyramid.levels;
  const auto only = static_cast<uint32_t>(settings_.only_level);
  Gathered sum;
  for (auto k = static_cast<uint32_t>(levels.size()); k-- > 0;) {
    Image own;
    if (only == 0 || only == k + 1) {
      own = gather_level(levels[k], k);
      ++sum.levels;
    }
    if (sum.light.valid()) {
      sum.light = combine(levels[k], k, levels[k + 1], kind, own, sum.light);
    } else {
      sum.light = own;
    }
    if (sum.light.valid()) sum.light = filter(levels[k], k, kind, sum.light);
  }
  return sum;
}

Gathered HierarchicalFrame::gather_all_levels(const Pyramid& pyramid, bool blocked) {
  return gather_levels(pyramid, "",
                       [&](const Level&, uint32_t k) { return gather(pyramid, k, blocked); });
}

Image HierarchicalFrame::add(const std::string& pass, Extent extent, Image a, Image b,
                             bool take_larger) {
  const Image sum = frame_.image("sum", extent, Format::rgba16f);
  frame_.dispatch(pass, {.shader = shaders::techniques_hierarchical_add_comp,
                         .constants = {{"take_larger", take_larger ? 1u : 0u}},
                         .params = AddParams{as_ivec2(extent)},
                         .read = {{"a", a}, {"b", b}},
                         .write = {{"sum", sum}},
                         .over = extent});
  return sum;
}

OutputParams HierarchicalFrame::output_params(const Pyramid& pyramid,
                                              const Gathered& gathered) const {
  const Level& level = pyramid.finest();
  return {pyramid.screen,         mat3(pyramid.view_from_world),
          level.screen.ray_scale, as_ivec2(pyramid.g_buffer.depth.extent),
          as_ivec2(level.extent), 1.0f / static_cast<float>(std::max(gathered.levels, 1u))};
}

Image HierarchicalFrame::output(const Pyramid& pyramid, const Gathered& gathered) {
  const GBuffer& g = pyramid.g_buffer;
  const Image diffuse = frame_.image("diffuse", g.depth.extent, Format::rgba16f);
  frame_.dispatch("hierarchical.output",
                  {.shader = shaders::techniques_hierarchical_output_comp,
                   .constants = {{"factor", static_cast<uint32_t>(pyramid.factor)}},
                   .params = output_params(pyramid, gathered),
                   .read = {{"geometry", pyramid.finest().geometry},
                            {"light", gathered.light},
                            {"depth", g.depth},
                            {"normal", g.normal}},
                   .write = {{"diffuse", diffuse}},
                   .over = corners_of(pyramid.finest().extent)});
  return diffuse;
}

}  // namespace lueur::hierarchical
