// SPDX-License-Identifier: MIT
#include "lueur/hbao.h"

#include <array>

#include "techniques/baselines/hbao/params.h"
#include "techniques/baselines/hbao/shaders.h"
#include "techniques/baselines/slice_passes.h"

namespace lueur {
namespace {

using Settings = HbaoSettings;

constexpr std::array kSettings = {
    setting<&Settings::slices>("slices", 1, 64, "slices", "Lines through a pixel."),
    setting<&Settings::samples>("samples", 1, 256, "samples", "On each side of a slice."),
    setting<&Settings::radius_m>("radius_m", 0.001, 10000, "m",
                                 "What is farther does not close a point in."),
    setting<&Settings::falloff>("falloff", 0, 1, "",
                                "Over which share of the radius, up to its end, it fades out."),
    toggle<&Settings::filter>("filter",
                              "Average 3 x 3 pixels of one surface, whose samples interleave."),
};

}  // namespace

std::span<const SettingInfo> Hbao::settings_table() {
  return kSettings;
}

Outputs Hbao::render(Frame& public_frame, const Inputs& inputs) {
  Recorder& frame = public_frame.recorder();
  if (auto valid = check_ranges(kSettings, &settings_); !valid.ok()) frame.fail(valid.error());
  if (frame.failed()) return {};
  SlicePasses passes(frame, "hbao", inputs);
  const Extent extent = passes.extent();
  const Image geometry = passes.geometry();
  Image light = frame.image("light", extent, Format::rgba16f);
  frame.dispatch("hbao.gather",
                 {.shader = shaders::techniques_baselines_hbao_gather_comp,
                  .params = HbaoParams{passes.screen(), as_ivec2(extent),
                                       static_cast<uint32_t>(settings_.slices),
                                       static_cast<uint32_t>(settings_.samples), inputs.seed,
                                       settings_.radius_m, settings_.falloff},
                  .read = {{"geometry", geometry}},
                  .write = {{"light", light}},
                  .over = extent});
  if (settings_.filter) light = passes.filter(geometry, light);
  frame.release(geometry);
  const Image occlusion = passes.occlusion(light);
  frame.release(light);
  return {.diffuse = {}, .specular = {}, .occlusion = occlusion};
}

}  // namespace lueur
