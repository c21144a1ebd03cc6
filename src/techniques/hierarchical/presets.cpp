// SPDX-License-Identifier: MIT
#include "techniques/hierarchical/presets.h"

namespace lueur {
namespace {

using Setting = std::pair<std::string_view, std::string_view>;

constexpr Setting kFast[] = {
    {"start", "quarter"}, {"levels", "4"}, {"samples", "64"}, {"sample_growth", "1"}};

constexpr Preset kPresets[] = {{"fast", "Coarser and with a shorter reach.", kFast},
                               {"balanced", "The defaults.", {}}};

}  // namespace

std::span<const Preset> hierarchical_presets() {
  return kPresets;
}

}  // namespace lueur
