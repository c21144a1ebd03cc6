// SPDX-License-Identifier: MIT
#include "techniques/hierarchical/presets.h"

namespace lueur {
namespace {

using Setting = std::pair<std::string_view, std::string_view>;

constexpr Setting kFast[] = {
    {"start", "quarter"}, {"levels", "4"}, {"samples", "32"}, {"sample_growth", "1"}};
constexpr Setting kQuality[] = {{"visibility", "first_bounce"},
                                {"visibility_steps", "16"},
                                {"sources", "lights"},
                                {"feedback", "true"},
                                {"glossy", "true"}};
constexpr Setting kReference[] = {
    {"light_view_px", "1024"},  {"samples", "256"},      {"visibility", "all_bounces"},
    {"visibility_steps", "32"}, {"voxel_slices", "512"}, {"sources", "lights"},
    {"bounces", "3"},           {"glossy", "true"},      {"glossy_samples", "128"}};

constexpr Preset kPresets[] = {
    {"fast", "Coarse, with a short reach: for slow machines.", kFast},
    {"balanced", "The defaults: one diffuse bounce of what the camera sees, no obstacles.", {}},
    {"quality", "What the lights see, with obstacles, all bounces and glossy surfaces.", kQuality},
    {"reference", "The most that the technique has, whatever it takes.", kReference}};

}  // namespace

std::span<const Preset> hierarchical_presets() {
  return kPresets;
}

}  // namespace lueur
