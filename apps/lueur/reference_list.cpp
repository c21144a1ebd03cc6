// SPDX-License-Identifier: MIT
#include "reference_list.h"

#include <algorithm>

#include "arguments.h"
#include "base/try.h"

namespace lueur::cli {
namespace {

Result<float> parse_above_zero(const std::string& where, const std::string& text, float most,
                               const char* expected) {
  LUEUR_TRY(value, parse_real(where, text, most));
  if (!(value > 0.0f))
    return Error{ErrorKind::usage, where + " " + text + ": expected " + expected};
  return value;
}

}  // namespace

Result<reference::Mode> parse_mode(std::string_view where, const std::string& text) {
  LUEUR_TRY(row, find_named(where, text, reference::mode_names()));
  return row->mode;
}

Result<void> set_reference(reference::Settings& settings, std::string_view where,
                           const std::string& key, const std::string& value) {
  const std::string flag = std::string(where) + key;
  if (key == "spp") {
    const uint32_t least = settings.mode == reference::Mode::screen_unoccluded ? 0 : 1;
    LUEUR_TRY(spp, parse_count(flag, value, least, reference::kMaxSpp));
    settings.spp = spp;
  } else if (key == "bounces") {
    LUEUR_TRY(bounces, parse_count(flag, value, 1, reference::kMaxBounces));
    settings.bounces = bounces;
  } else if (key == "error") {
    LUEUR_TRY(target, parse_above_zero(flag, value, 1.0f, "a share above 0, as 0.01 for 1 %"));
    settings.target_error = static_cast<double>(target);
  } else if (key == "distance") {
    LUEUR_TRY(distance_m, parse_above_zero(flag, value, 1e6f, "metres above 0"));
    settings.ambient_distance_m = distance_m;
  } else if (key == "form-factor") {
    if (value != "disc" && value != "point")
      return Error{ErrorKind::usage, flag + " '" + value + "': expected one of disc, point"};
    settings.form_factor =
        value == "disc" ? reference::FormFactor::disc : reference::FormFactor::point;
  } else {
    return Error{ErrorKind::usage,
                 flag +
                     ": no such setting of a reference; there is spp, bounces, error, distance, "
                     "form-factor"};
  }
  return {};
}

Result<std::vector<ChosenReference>> choose_references(std::string_view flag, std::string_view list,
                                                       const reference::Settings& defaults) {
  std::vector<ChosenReference> all;
  if (list.empty()) return all;
  for (const std::string& entry : split(list, ',')) {
    const std::string where = std::string(flag) + " '" + entry + "'";
    const std::vector<std::string> parts = split(entry, ':');
    ChosenReference chosen{entry, defaults};
    LUEUR_TRY(mode, parse_mode(flag, parts.front()));
    chosen.settings.mode = mode;
    // As many samples as a path takes say little of a picture's pixels: sum all of them.
    if (mode == reference::Mode::screen_unoccluded) chosen.settings.spp = 0;
    if (mode == reference::Mode::lights || mode == reference::Mode::lights_unoccluded)
      chosen.settings.spp = reference::kLights;
    for (size_t i = 1; i < parts.size(); ++i) {
      LUEUR_TRY(parsed, parse_assignment(where, parts[i]));
      LUEUR_TRY_VOID(set_reference(chosen.settings, where + ": ", parsed.key, parsed.value));
    }
    const bool twice = std::any_of(all.begin(), all.end(), [&](const ChosenReference& other) {
      return other.label == chosen.label;
    });
    if (twice) return Error{ErrorKind::usage, where + " is given twice; give it once"};
    all.push_back(std::move(chosen));
  }
  return all;
}

}  // namespace lueur::cli
