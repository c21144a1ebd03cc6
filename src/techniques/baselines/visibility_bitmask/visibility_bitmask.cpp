// SPDX-License-Identifier: MIT
#include "lueur/visibility_bitmask.h"

#include <array>

#include "techniques/baselines/slice_passes.h"
#include "techniques/baselines/visibility_bitmask/params.h"
#include "techniques/baselines/visibility_bitmask/shaders.h"

namespace lueur {
namespace {

using Settings = VisibilityBitmaskSettings;

constexpr std::string_view kFilterNames[] = {"none", "3x3", "9x9"};

constexpr std::array kSettings = {
    setting<&Settings::slices>("slices", 1, 64, "slices", "Lines through a pixel."),
    setting<&Settings::samples>("samples", 1, 256, "samples", "On each side of a slice."),
    setting<&Settings::radius_m>("radius_m", 0.001, 10000, "m", "How far light comes from."),
    setting<&Settings::distance_m>("distance_m", 0.001, 10000, "m",
                                   "What is nearer counts as occlusion, within `radius_m`."),
    setting<&Settings::thickness_m>("thickness_m", 0, 10000, "m",
                                    "How deep everything is behind what the eye sees of it."),
    toggle<&Settings::bridge>(
        "bridge", "Cover what lies between two samples that follow each other on one surface."),
    toggle<&Settings::emitter_cosine>(
        "emitter_cosine", "Multiply light by the cosine at which it leaves, as the paper does."),
    choice<&Settings::filter>("filter", kFilterNames,
                              "Over how many pixels of one surface to average light, whose samples "
                              "interleave; occlusion over 3x3 at most."),
};

}  // namespace

std::span<const SettingInfo> VisibilityBitmask::settings_table() {
  return kSettings;
}

Outputs VisibilityBitmask::render(Frame& public_frame, const Inputs& inputs) {
  Recorder& frame = public_frame.recorder();
  if (auto valid = check_ranges(kSettings, &settings_); !valid.ok()) frame.fail(valid.error());
  if (frame.failed()) return {};
  SlicePasses passes(frame, "visibility_bitmask", inputs);
  const Extent extent = passes.extent();
  const Image geometry = passes.geometry();
  Image light = frame.image("light", extent, Format::rgba16f);
  frame.dispatch(
      "visibility_bitmask.gather",
      {.shader = shaders::techniques_baselines_visibility_bitmask_gather_comp,
       .constants = {{"emitter_cosine", settings_.emitter_cosine ? 1u : 0u},
                     {"bridge", settings_.bridge ? 1u : 0u}},
       .params =
           BitmaskParams{passes.screen(), as_ivec2(extent), static_cast<uint32_t>(settings_.slices),
                         static_cast<uint32_t>(settings_.samples), inputs.seed, settings_.radius_m,
                         settings_.distance_m, settings_.thickness_m},
       .read = {{"geometry", geometry}, {"source", inputs.g_buffer.source}},
       .write = {{"light", light}},
       .over = extent});
  if (settings_.filter != Settings::Filter::none) light = passes.filter(geometry, light);
  const Image occlusion = passes.occlusion(light);
  if (settings_.filter == Settings::Filter::nine) light = passes.widen(geometry, light);
  frame.release(geometry);
  return {.diffuse = light, .specular = {}, .occlusion = occlusion};
}

}  // namespace lueur
