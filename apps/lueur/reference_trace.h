// SPDX-License-Identifier: MIT
// References that another command needs, rendered with its progress on the terminal.
#pragma once

#include <stop_token>
#include <string>

#include "reference/rendering_file.h"

namespace lueur::cli {

// One line: samples done, error, time left.
std::string describe(const reference::Progress& progress);

// As reference::render_cached() from the start, on all threads; `label` says in the progress which
// one it is, and a note about the cache is a warning. Not complete where `stop` asked for an early
// end.
Result<reference::CachedRendering> trace_reference(const Scene& scene, const reference::Shot& shot,
                                                   const reference::Settings& settings,
                                                   const std::string& label,
                                                   const std::stop_token& stop,
                                                   reference::Cache cache);

}  // namespace lueur::cli
