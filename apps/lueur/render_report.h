// SPDX-License-Identifier: MIT
// What `lueur render` has found out, and how it is told: JSON, the headers of EXR files, findings.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "json_output.h"
#include "render_job.h"
#include "session.h"

namespace lueur::cli {

struct RenderReport {
  std::string camera;
  gpu::DeviceEntry device;
  uint64_t triangles = 0;
  double load_ms = 0;
  float exposure_ev = 0;
  std::vector<PassTime> passes;  // of the picture, or medians of all frames
  double technique_ms = 0;
  double host_ms = 0;  // what the host renders for the technique alone
  double frame_ms = 0;
  std::optional<MemoryUse> memory;         // of one frame without copies for the CPU
  std::optional<double> off_screen_share;  // where alpha holds it
  std::optional<uint32_t> frames;          // those written, of an animation
  std::vector<std::string> views;          // "pass.image", each once
  std::vector<ScanFinding> findings;       // of a scan
  std::vector<std::string> validation_messages;
  std::vector<std::string> outputs;
  std::vector<std::string> warnings;
};

// For the header of an EXR file that shows frame `frame`.
std::map<std::string, std::string> attributes(const RenderJob& job, const RenderReport& report,
                                              const Shot& shot);

Json report_json(const RenderJob& job, const RenderReport& report);

// Says on stderr what the checks have found; kExitFinding then.
int print_findings(const RenderReport& report);

}  // namespace lueur::cli
