// SPDX-License-Identifier: MIT
#include "reference_trace.h"

#include <cmath>
#include <cstdio>

#include "base/try.h"
#include "console.h"

namespace lueur::cli {

std::string describe(const reference::Progress& p) {
  char line[160];
  std::snprintf(line, sizeof(line), "%u of %u samples a pixel, error %.2f %%, %.0f s left",
                p.spp_done, p.spp_total,
                std::isfinite(p.relative_error) ? 100.0 * p.relative_error : 100.0, p.seconds_left);
  return line;
}

Result<reference::CachedRendering> trace_reference(const Scene& scene, const reference::Shot& shot,
                                                   const reference::Settings& settings,
                                                   const std::string& label,
                                                   const std::stop_token& stop,
                                                   reference::Cache cache) {
  const reference::Control control{.progress =
                                       [&](const reference::Progress& p) {
                                         print_progress("tracing " + label + ": " + describe(p));
                                       },
                                   .stop = stop,
                                   .checkpoint = {}};
  LUEUR_TRY(traced, reference::render_cached(scene, shot, settings, control, {}, cache));
  if (!traced.cache_note.empty()) print_warning(traced.cache_note);
  return traced;
}

}  // namespace lueur::cli
