// SPDX-License-Identifier: MIT
// References chosen by what a user typed: `path,path:bounces=4:spp=64,screen`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/reference.h"

namespace lueur::cli {

struct ChosenReference {
  std::string label;  // the entry in the list: "path:bounces=4"
  reference::Settings settings;
};

Result<reference::Mode> parse_mode(std::string_view where, const std::string& text);

// Sets `spp`, `bounces`, `error`, `distance` or `form-factor` from text. The error
// (ErrorKind::usage) begins with `where` and the key.
Result<void> set_reference(reference::Settings& settings, std::string_view where,
                           const std::string& key, const std::string& value);

// Entries `mode:key=value:key=value`, separated by commas, in their order, each given once; what an
// entry leaves out is that of `defaults`. An empty list is no reference.
Result<std::vector<ChosenReference>> choose_references(std::string_view flag, std::string_view list,
                                                       const reference::Settings& defaults);

}  // namespace lueur::cli
