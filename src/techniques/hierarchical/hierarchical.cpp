// SPDX-License-Identifier: MIT
#include "lueur/hierarchical.h"

#include <array>

#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/hierarchical_frame.h"

namespace lueur {
namespace {

using hierarchical::Gathered;
using hierarchical::HierarchicalFrame;
using hierarchical::Pyramid;
using hierarchical::Warped;
using Settings = HierarchicalSettings;

constexpr std::string_view kStartNames[] = {"full", "half", "quarter"};
constexpr std::string_view kSideViewNames[] = {"gather", "warp"};
constexpr std::string_view kSourcesNames[] = {"camera", "lights"};
constexpr std::string_view kOffScreenNames[] = {"none", "map"};
constexpr std::string_view kVisibilityNames[] = {"none", "first_bounce", "all_bounces"};
constexpr std::string_view kSlicesNames[] = {"32", "64", "128", "256", "512"};
constexpr std::string_view kVoxelizerNames[] = {"compute", "raster"};
constexpr std::string_view kPyramidNames[] = {"closest", "vote"};
constexpr std::string_view kFormFactorNames[] = {"disc", "point"};
constexpr std::string_view kSamplingNames[] = {"sparse", "every_pixel"};

constexpr std::array kSettings = {
    choice<&Settings::start>("start", kStartNames,
                             "Resolution of level 0, the finest that gathers light."),
    choice<&Settings::pyramid>(
        "pyramid", kPyramidNames,
        "Which of the pixels below decides on a coarser one: closest: the nearest; vote: the one "
        "whose surface most neighbours share."),
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
    choice<&Settings::visibility>("visibility", kVisibilityNames,
                                  "Which bounces obstacles block, found in voxels; above none it "
                                  "needs the engine's triangles."),
    choice<&Settings::voxel_slices>("voxel_slices", kSlicesNames, "Voxels in depth."),
    setting<&Settings::visibility_steps>("visibility_steps", 1, 128, "steps",
                                         "Of a ray through voxels, at most."),
    setting<&Settings::visibility_finer>("visibility_finer", 0, 8, "levels",
                                         "Rays go through voxels of a level so much finer than "
                                         "that of their samples. 0: the same, as in the paper."),
    choice<&Settings::voxelizer>("voxelizer", kVoxelizerNames,
                                 "compute: in a compute shader; raster: drawn, as in the paper."),
    choice<&Settings::sources>("sources", kSourcesNames,
                               "What gives the first bounce: camera: what it sees; lights: what "
                               "each of them shines on, which needs the engine's other views."),
    setting<&Settings::light_view_px>("light_view_px", 16, 4096, "px",
                                      "Side of a light's view, with `sources=lights`."),
    choice<&Settings::off_screen>(
        "off_screen", kOffScreenNames,
        "What gives the first bounce beside the picture: none: nothing; map: a cube map around the "
        "eye, which needs the engine's other views."),
    choice<&Settings::side_views>("side_views", kSideViewNames,
                                  "How light of side cameras is taken, with sources=camera: "
                                  "gather: from what they see; warp: "
                                  "they gather for themselves, as in the paper."),
    toggle<&Settings::glossy>("glossy",
                              "Also give the light that glossy lobes reflect; needs reflectance."),
    setting<&Settings::glossy_samples>("glossy_samples", 1, 256, "samples",
                                       "Samples a pixel takes for it at each level."),
    toggle<&Settings::glossy_importance>("glossy_importance",
                                         "Draw them around where the lobe leads on the screen."),
    setting<&Settings::temporal>(
        "temporal", 0, 0.98, "",
        "Largest share of the last frame in this one; needs motion. 0: none."),
    toggle<&Settings::temporal_clamp>(
        "temporal_clamp", "Bring the last frame's light into the range of its new neighbours."),
    setting<&Settings::bounces>("bounces", 1, 4, "bounces",
                                "Surfaces that light comes off on its way; above 1 needs albedo."),
    toggle<&Settings::interleave>("interleave",
                                  "Two bounces, the first in even and the second in odd frames."),
    toggle<&Settings::feedback>(
        "feedback", "Add what surfaces reflect of the last frame's result: all bounces, in time."),
    setting<&Settings::only_level>("only_level", 0, 8, "",
                                   "Gather at this level only, counted from 1; 0: at all levels."),
};

// Settings that do not fit each other or what the engine gives.
Result<void> check_inputs(const Settings& settings, const Inputs& inputs) {
  const auto refuse = [](std::string message) {
    return Error{ErrorKind::usage, std::move(message)};
  };
  if (settings.only_level > settings.levels)
    return refuse("only_level=" + std::to_string(settings.only_level) +
                  " is above levels=" + std::to_string(settings.levels));
  if (settings.interleave && settings.bounces != 2)
    return refuse("interleave=true is for bounces=2, not " + std::to_string(settings.bounces));
  if (settings.interleave && settings.feedback)
    return refuse("interleave=true and feedback=true: choose one of the two");
  const GBuffer& g = inputs.g_buffer;
  if ((settings.bounces > 1 || settings.feedback) && !g.albedo.valid())
    return refuse("bounces above 1 and feedback=true need the G-buffer's albedo");
  if ((settings.interleave || settings.feedback) && !g.motion.valid())
    return refuse("interleave=true and feedback=true need the G-buffer's motion");
  if (settings.glossy && !g.reflectance.valid())
    return refuse("glossy=true needs the G-buffer's reflectance");
  if (settings.visibility != Settings::Visibility::none && !inputs.host)
    return refuse("visibility above none needs an engine that lends triangles (Inputs::host)");
  if (settings.visibility != Settings::Visibility::none &&
      settings.sampling == Settings::Sampling::every_pixel)
    return refuse("visibility above none goes with sampling=sparse only");
  if (!inputs.side_views.empty() && !inputs.host)
    return refuse("side views need an engine that renders other views (Inputs::host)");
  if (settings.sources == Settings::Sources::lights && !inputs.host)
    return refuse("sources=lights needs an engine that renders other views (Inputs::host)");
  if (settings.off_screen == Settings::OffScreen::map) {
    if (!inputs.host)
      return refuse("off_screen=map needs an engine that renders other views (Inputs::host)");
    if (settings.sources == Settings::Sources::lights)
      return refuse("off_screen=map goes with sources=camera: lights see what is off the screen");
  }
  return {};
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
  if (auto given = check_inputs(settings_, inputs); !given.ok()) frame.fail(given.error());
  if (frame.failed()) return {};

  HierarchicalFrame steps(public_frame, settings_, inputs);
  const bool has_voxels = settings_.visibility != Settings::Visibility::none;
  const bool remembers = steps.has_history();
  const auto levels = static_cast<uint32_t>(settings_.levels);
  const bool by_lights = settings_.sources == Settings::Sources::lights;
  Pyramid pyramid = steps.begin_pyramid(
      inputs.view, inputs.g_buffer,
      {.factor = 1 << static_cast<int>(settings_.start),
       .keeps_history = remembers,
       .source = by_lights ? inputs.g_buffer.emission : inputs.g_buffer.source});
  Image albedo;
  if (settings_.bounces > 1 || settings_.feedback) albedo = steps.albedo(pyramid);

  Gathered gathered;
  if (settings_.interleave) {
    steps.finish_pyramid(pyramid, levels);
    if (has_voxels) steps.voxelize(pyramid);
    gathered = steps.gather_in_turn(pyramid, albedo, frames_++ % 2 == 1);
  } else {
    Warped before;
    if (remembers) before = steps.warp(pyramid, "light");
    if (settings_.feedback) steps.feed_back(pyramid, albedo, before);
    steps.finish_pyramid(pyramid, levels);
    if (has_voxels) steps.voxelize(pyramid);
    gathered = steps.gather_bounces(pyramid, albedo);
    if (remembers) {
      const Image now = steps.blend(pyramid, "light", before, gathered.light);
      frame.release(before.light);
      frame.release(gathered.light);
      gathered.light = now;
    }
  }
  if (frame.failed()) return {};
  Outputs outputs{.diffuse = steps.output(pyramid, gathered)};
  if (settings_.glossy) outputs.specular = steps.glossy(pyramid, albedo, gathered);
  frame.release(gathered.light);
  frame.release(gathered.but_last);
  frame.release(albedo);
  steps.release(pyramid);
  return outputs;
}

}  // namespace lueur
