// SPDX-License-Identifier: MIT
#include "lueur/hierarchical.h"

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

#include "frame/recorder.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"
#include "techniques/hierarchical/shaders.h"
#include "techniques/screen_of_view.h"

namespace lueur {
namespace {

using Settings = HierarchicalSettings;

constexpr std::string_view kStartNames[] = {"full", "half", "quarter"};
constexpr std::string_view kFormFactorNames[] = {"disc", "point"};
constexpr std::string_view kSamplingNames[] = {"sparse", "every_pixel"};

constexpr std::array kSettings = {
    choice<&Settings::start>("start", kStartNames,
                             "Resolution of level 0, the finest that gathers light."),
    setting<&Settings::levels>("levels", 1, 8, "levels",
                               "Levels of the pyramid; each doubles the reach."),
    setting<&Settings::samples>("samples", 1, 256, "samples",
                                "Samples a pixel takes at the two finest levels."),
    setting<&Settings::sample_growth>("sample_growth", 1, 4, "times",
                                      "Each further level takes so many times the samples of the "
                                      "one before, at most every pixel."),
    setting<&Settings::radius>(
        "radius", 1, 4096, "px",
        "Radius of the ring in pixels of its level; level k reaches radius * 2^k."),
    choice<&Settings::form_factor>(
        "form_factor", kFormFactorNames,
        "disc: HSSIL (4), bounded; point: HSSIL (3), noisy where surfaces meet."),
    choice<&Settings::sampling>(
        "sampling", kSamplingNames,
        "sparse: as many samples as `samples`; every_pixel: all pixels of the ring, slow."),
    toggle<&Settings::rotate>(
        "rotate", "Give neighbouring pixels different samples, which `filter` averages."),
    toggle<&Settings::filter>("filter", "Filter each level 3 x 3 along its surfaces."),
    setting<&Settings::only_level>("only_level", 0, 8, "",
                                   "Gather at this level only, counted from 1; 0: at all levels."),
};

// One level of the pyramid.
struct Level {
  Extent extent;
  Screen screen;   // ray_scale is a level pixel's
  Image geometry;  // see pyramid.glsl
  Image source;
};

ivec2 as_ivec2(Extent e) {
  return ivec2(e.width, e.height);
}

// upsample.glsl takes one thread for each corner between coarse pixels, the image's edges included.
Extent corners_of(Extent coarse) {
  return {coarse.width + 1, coarse.height + 1};
}

std::string at_level(const char* pass, uint32_t level) {
  return std::string("hierarchical.") + pass + "@" + std::to_string(level);
}

// One frame of the technique: what all passes share.
struct Pass {
  Recorder& frame;
  const Settings& settings;
  const Inputs& inputs;
  Screen screen;  // of the G-buffer
  int factor;     // pixels of the G-buffer a side of one pixel of level 0
  mat3 view_from_world;

  std::vector<Level> build_pyramid();
  uint32_t gather_pixels_per_thread(Extent level) const;
  Image gather(const Level& level, uint32_t index);
  Image filter(const Level& level, uint32_t index, Image light);
  Image combine(const Level& fine, uint32_t index, const Level& coarse, Image own, Image light);
  Image output(const Level& level, Image light, uint32_t gathered_levels);
};

// HSSIL 3.2, "mipmapping": level 0 from the engine's images, the others each from the one before.
std::vector<Level> Pass::build_pyramid() {
  const GBuffer& g = inputs.g_buffer;
  std::vector<Level> levels;
  for (uint32_t k = 0; k < static_cast<uint32_t>(settings.levels); ++k) {
    const Extent finer = k == 0 ? g.depth.extent : levels.back().extent;
    const uint32_t step = k == 0 ? static_cast<uint32_t>(factor) : 2u;
    Level level;
    level.extent = {divide_up(finer.width, step), divide_up(finer.height, step)};
    level.screen = screen;
    level.screen.ray_scale *= static_cast<float>(factor << k);
    level.geometry = frame.image("geometry", level.extent, Format::rgba32f);
    level.source = frame.image("source", level.extent, Format::rgba16f);
    const std::string name = at_level("pyramid", k);
    if (k == 0) {
      frame.dispatch(name,
                     {.shader = shaders::techniques_hierarchical_prepare_comp,
                      .constants = {{"factor", static_cast<uint32_t>(factor)}},
                      .params = PrepareParams{screen, view_from_world, as_ivec2(g.depth.extent),
                                              as_ivec2(level.extent)},
                      .read = {{"depth", g.depth}, {"normal", g.normal}, {"source", g.source}},
                      .write = {{"geometry_out", level.geometry}, {"source_out", level.source}},
                      .over = level.extent});
    } else {
      const Level& fine = levels.back();
      frame.dispatch(name,
                     {.shader = shaders::techniques_hierarchical_downsample_comp,
                      .params = DownsampleParams{level.screen, fine.screen.ray_scale,
                                                 as_ivec2(fine.extent), as_ivec2(level.extent)},
                      .read = {{"geometry", fine.geometry}, {"source", fine.source}},
                      .write = {{"geometry_out", level.geometry}, {"source_out", level.source}},
                      .over = level.extent});
    }
    levels.push_back(level);
  }
  return levels;
}

// A CPU wants much work in each thread (8 pixels took 0.90 of the time of 4), but still several
// workgroups to share out.
uint32_t Pass::gather_pixels_per_thread(Extent level) const {
  constexpr uint32_t kRowsWorthIt = 16;
  return frame.runs_on_cpu() && level.height >= kRowsWorthIt ? 8 : 1;
}

// HSSIL 3.2, "indirect lighting shader": equation (4) over the level's ring.
Image Pass::gather(const Level& level, uint32_t index) {
  const bool every_pixel = settings.sampling == Settings::Sampling::every_pixel;
  const uint32_t samples = samples_at_level(settings, index);
  const float pixels_per_sample =
      every_pixel ? 1.0f : ring_area_px(index, settings.radius) / static_cast<float>(samples);
  GatherParams params{};
  params.screen = level.screen;
  params.extent = as_ivec2(level.extent);
  params.inner_px = ring_inner_px(index, settings.radius);
  params.outer_px = settings.radius;
  params.area_over_pi = pixels_per_sample *
                        std::abs(level.screen.ray_scale.x * level.screen.ray_scale.y) /
                        std::numbers::pi_v<float>;
  params.samples = samples;
  params.level = index;
  params.seed = inputs.seed;
  params.rotate = settings.rotate;

  const Image indirect = frame.image("indirect", level.extent, Format::rgba16f);
  const uint32_t pixels_per_thread = every_pixel ? 1 : gather_pixels_per_thread(level.extent);
  Dispatch dispatch{
      .shader = every_pixel ? shaders::techniques_hierarchical_gather_all_comp
                            : shaders::techniques_hierarchical_gather_comp,
      .constants = {{"form_factor", static_cast<uint32_t>(settings.form_factor)}},
      .params = params,
      .read = {{"geometry", level.geometry}, {"source", level.source}},
      .write = {{"indirect", indirect}},
      .over = {level.extent.width,
               // Rows in groups of 3 a thread, see gather.comp.
               every_pixel ? level.extent.height
                           : 3 * divide_up(level.extent.height, 3 * pixels_per_thread)}};
  if (!every_pixel) dispatch.constants.push_back({"pixels_per_thread", pixels_per_thread});
  frame.dispatch(at_level("gather", index), dispatch);
  return indirect;
}

Image Pass::filter(const Level& level, uint32_t index, Image light) {
  if (!settings.filter) return light;
  const Image filtered = frame.image("filtered", level.extent, Format::rgba16f);
  frame.dispatch(at_level("filter", index),
                 {.shader = shaders::techniques_hierarchical_filter_comp,
                  .params = FilterParams{level.screen, as_ivec2(level.extent)},
                  .read = {{"geometry", level.geometry}, {"light", light}},
                  .write = {{"filtered", filtered}},
                  .over = level.extent});
  frame.release(light);
  return filtered;
}

// HSSIL 3.2, "continuous combination of all level contributions". `own` invalid: the fine level has
// gathered nothing.
Image Pass::combine(const Level& fine, uint32_t index, const Level& coarse, Image own,
                    Image light) {
  const Image combined = frame.image("combined", fine.extent, Format::rgba16f);
  frame.dispatch(
      at_level("combine", index),
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
  frame.release(light);
  frame.release(own);
  return combined;
}

Image Pass::output(const Level& level, Image light, uint32_t gathered_levels) {
  const GBuffer& g = inputs.g_buffer;
  const Image diffuse = frame.image("diffuse", g.depth.extent, Format::rgba16f);
  frame.dispatch("hierarchical.output",
                 {.shader = shaders::techniques_hierarchical_output_comp,
                  .constants = {{"factor", static_cast<uint32_t>(factor)}},
                  .params = OutputParams{screen, view_from_world, level.screen.ray_scale,
                                         as_ivec2(g.depth.extent), as_ivec2(level.extent),
                                         1.0f / static_cast<float>(gathered_levels)},
                  .read = {{"geometry", level.geometry},
                           {"light", light},
                           {"depth", g.depth},
                           {"normal", g.normal}},
                  .write = {{"diffuse", diffuse}},
                  .over = corners_of(level.extent)});
  frame.release(light);
  return diffuse;
}

}  // namespace

std::span<const SettingInfo> Hierarchical::settings_table() {
  return kSettings;
}

uint32_t samples_at_level(const HierarchicalSettings& settings, uint32_t level) {
  uint32_t samples = static_cast<uint32_t>(settings.samples);
  const auto ring_px = static_cast<uint32_t>(std::max(ring_area_px(level, settings.radius), 1.0f));
  for (uint32_t k = 2; k <= level && samples < ring_px; ++k)
    samples = std::min(samples * static_cast<uint32_t>(settings.sample_growth), ring_px);
  return samples;
}

Outputs Hierarchical::render(Frame& public_frame, const Inputs& inputs) {
  Recorder& frame = public_frame.recorder();
  if (auto valid = check_ranges(kSettings, &settings_); !valid.ok()) frame.fail(valid.error());
  if (settings_.only_level > settings_.levels)
    frame.fail({ErrorKind::usage, "only_level=" + std::to_string(settings_.only_level) +
                                      " is above levels=" + std::to_string(settings_.levels)});
  if (frame.failed()) return {};

  Pass pass{frame,
            settings_,
            inputs,
            screen_of_view(inputs.view, inputs.g_buffer.depth.extent),
            1 << static_cast<int>(settings_.start),
            mat3(glm::make_mat4(inputs.view.view_from_world.data()))};
  const std::vector<Level> levels = pass.build_pyramid();

  // Gather from coarse to fine, adding each level to what came up from below.
  const uint32_t only = static_cast<uint32_t>(settings_.only_level);
  uint32_t gathered_levels = 0;
  Image light;
  for (uint32_t k = static_cast<uint32_t>(levels.size()); k-- > 0;) {
    Image own;
    if (only == 0 || only == k + 1) {
      own = pass.gather(levels[k], k);
      ++gathered_levels;
    }
    if (light.valid()) {
      light = pass.combine(levels[k], k, levels[k + 1], own, light);
    } else {
      light = own;
    }
    if (light.valid()) light = pass.filter(levels[k], k, light);
  }
  if (frame.failed()) return {};
  const Outputs outputs{.diffuse = pass.output(levels[0], light, gathered_levels)};
  for (const Level& level : levels) {
    frame.release(level.geometry);
    frame.release(level.source);
  }
  return outputs;
}

}  // namespace lueur
