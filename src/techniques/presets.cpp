// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "base/try.h"
#include "lueur/technique.h"

namespace lueur {

Result<void> apply_preset(const TechniqueInfo& info, std::string_view preset, void* settings) {
  const auto found =
      std::find_if(info.presets.begin(), info.presets.end(),
                   [&](const Preset& candidate) { return candidate.name == preset; });
  if (found == info.presets.end()) {
    std::string names;
    for (const Preset& known : info.presets)
      names += (names.empty() ? "" : ", ") + std::string(known.name);
    return Error{ErrorKind::usage,
                 "preset '" + std::string(preset) + "': " + std::string(info.name) +
                     (names.empty() ? " has no presets" : " has the presets " + names)};
  }
  const auto defaults = info.make();
  for (const SettingInfo& row : info.settings) row.set(settings, row.get(defaults->settings()));
  for (const auto& [name, text] : found->settings)
    LUEUR_TRY_VOID(set_from_text(info.settings, settings, name, text));
  return {};
}

}  // namespace lueur
