// SPDX-License-Identifier: MIT
// --limit NAME=VALUE: what a scene file may ask for, in the commands that load one.
#pragma once

#include <string>

#include "lueur/result.h"
#include "scene/gltf_load.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace lueur::cli {

// May be repeated; each writes into `limits` when the command line is read.
void add_limit_option(CLI::App& command, LoadLimits& limits);

// Sets one of the limits by "name=value". The error names the limits there are, or the range.
Result<void> set_limit(LoadLimits& limits, const std::string& assignment);

}  // namespace lueur::cli
