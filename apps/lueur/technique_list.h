// SPDX-License-Identifier: MIT
// Techniques with settings, chosen by what a user typed: one by --technique, --preset and --set, or
// several by a list such as `hierarchical,hierarchical:preset=fast:samples=32,none`.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lueur/technique.h"

namespace lueur::cli {

struct ChosenTechnique {
  const TechniqueInfo* info = nullptr;  // nullptr: direct light only
  std::unique_ptr<Technique> technique;
  std::string label = "none";  // the entry in a list that chooses it: "hierarchical:samples=32"
  std::string name() const { return info ? std::string(info->name) : "none"; }
  // As TechniqueInfo has it.
  std::string_view diffuse_alpha() const { return info ? info->diffuse_alpha : ""; }
};

// One technique. `settings` are "key=value" texts as they came with --set, `preset` the name of the
// preset on top of which they go, or "".
Result<ChosenTechnique> choose_technique(const std::string& name,
                                         const std::vector<std::string>& settings,
                                         const std::string& preset = "");

// Entries `name:key=value:key=value`, separated by commas, in their order; at least one, each given
// once. The first key may be `preset`. No value holds a comma or a colon. The error
// (ErrorKind::usage) names `flag` and the entry.
Result<std::vector<ChosenTechnique>> choose_techniques(std::string_view flag,
                                                       std::string_view list);

// Changes one setting and adds it to the label. `assignment` is "key=value"; the error begins with
// `where`.
Result<void> change(ChosenTechnique& chosen, std::string_view where, const std::string& assignment);

// Another instance, with the same settings.
ChosenTechnique copy(const ChosenTechnique& chosen);

}  // namespace lueur::cli
