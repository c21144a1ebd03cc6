// SPDX-License-Identifier: MIT
// What `lueur bench` has found out, as JSON and as text of at most 100 columns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "candidate.h"
#include "frame_options.h"
#include "json_output.h"
#include "scaling.h"
#include "timing.h"

namespace lueur::cli {

struct BenchReport {
  gpu::DeviceEntry device;
  FrameSetup setup;
  uint32_t frames = 0;
  MemoryUse memory;  // of all candidates together
  std::vector<Candidate> candidates;
  std::vector<Summary> summaries;  // by candidate
  std::optional<Scale> scale;      // if the candidates are series
  std::vector<Series> series;
};

// One candidate stands in the object itself, several in its array "runs". Times in milliseconds are
// medians; "X_spread" says where the others lie.
Json bench_json(const BenchReport& report);

std::string bench_text(const BenchReport& report);

// Most over least technique time of those candidates that have one; 1 if none has.
double max_over_min(const std::vector<Summary>& summaries);

}  // namespace lueur::cli
