// SPDX-License-Identifier: MIT
#include "technique_list.h"

#include <algorithm>

#include "arguments.h"
#include "base/try.h"

namespace lueur::cli {
namespace {

constexpr std::string_view kPresetKey = "preset=";

Result<ChosenTechnique> choose(const std::string& name, const std::string& where) {
  ChosenTechnique chosen;
  if (name == "none") return chosen;
  chosen.info = find_technique(name);
  if (!chosen.info) {
    std::vector<std::string> names = {"none"};
    for (const TechniqueInfo& info : techniques()) names.emplace_back(info.name);
    return Error{ErrorKind::usage, where + ": no such technique; there is " + joined(names)};
  }
  chosen.technique = chosen.info->make();
  chosen.label = name;
  return chosen;
}

// The first thing that is done to `chosen`, as it decides all settings. The error begins with
// `where` and "preset".
Result<void> put_preset(ChosenTechnique& chosen, const std::string& where,
                        const std::string& preset) {
  if (!chosen.info)
    return Error{ErrorKind::usage, where + "preset '" + preset +
                                       "': the technique none has no presets; leave it out"};
  const auto applied = apply_preset(*chosen.info, preset, chosen.technique->settings());
  if (!applied.ok()) return Error{applied.error().kind, where + applied.error().message};
  chosen.label += ":" + std::string(kPresetKey) + preset;
  return {};
}

// One entry of a list.
Result<ChosenTechnique> choose_entry(const std::string& entry, const std::string& where) {
  const std::vector<std::string> parts = split(entry, ':');
  LUEUR_TRY(chosen, choose(parts.front(), where));
  for (size_t i = 1; i < parts.size(); ++i) {
    if (!parts[i].starts_with(kPresetKey)) {
      LUEUR_TRY_VOID(change(chosen, where + ":", parts[i]));
    } else if (i == 1) {
      LUEUR_TRY_VOID(put_preset(chosen, where + ": ", parts[i].substr(kPresetKey.size())));
    } else {
      return Error{ErrorKind::usage, where + ": write the preset first; settings go on top of it"};
    }
  }
  return std::move(chosen);
}

}  // namespace

Result<ChosenTechnique> choose_technique(const std::string& name,
                                         const std::vector<std::string>& settings,
                                         const std::string& preset) {
  LUEUR_TRY(chosen, choose(name, "--technique '" + name + "'"));
  if (!preset.empty()) LUEUR_TRY_VOID(put_preset(chosen, "--", preset));
  for (const std::string& text : settings) LUEUR_TRY_VOID(change(chosen, "--set", text));
  return std::move(chosen);
}

Result<std::vector<ChosenTechnique>> choose_techniques(std::string_view flag,
                                                       std::string_view list) {
  std::vector<ChosenTechnique> all;
  for (const std::string& entry : split(list, ',')) {
    const std::string where = std::string(flag) + " '" + entry + "'";
    LUEUR_TRY(chosen, choose_entry(entry, where));
    const bool twice = std::any_of(all.begin(), all.end(), [&](const ChosenTechnique& other) {
      return other.label == chosen.label;
    });
    if (twice) return Error{ErrorKind::usage, where + " is given twice; give it once"};
    all.push_back(std::move(chosen));
  }
  return all;
}

Result<void> change(ChosenTechnique& chosen, std::string_view where,
                    const std::string& assignment) {
  LUEUR_TRY(parsed, parse_assignment(where, assignment));
  if (!chosen.info)
    return Error{ErrorKind::usage, std::string(where) + " " + assignment +
                                       ": the technique none has no settings; leave it out"};
  const auto set =
      set_from_text(chosen.info->settings, chosen.technique->settings(), parsed.key, parsed.value);
  if (!set.ok()) return Error{set.error().kind, std::string(where) + " " + set.error().message};
  chosen.label += ":" + assignment;
  return {};
}

ChosenTechnique copy(const ChosenTechnique& chosen) {
  ChosenTechnique other{chosen.info, nullptr, chosen.label};
  if (!chosen.info) return other;
  other.technique = chosen.info->make();
  for (const SettingInfo& row : chosen.info->settings)
    row.set(other.technique->settings(), row.get(chosen.technique->settings()));
  return other;
}

}  // namespace lueur::cli
