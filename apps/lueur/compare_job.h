// SPDX-License-Identifier: MIT
// What `lueur compare` is to do, all of it checked, and the doing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "commands.h"
#include "frame_options.h"
#include "reference/rendering_file.h"
#include "reference_list.h"
#include "scene/gltf_load.h"
#include "technique_list.h"

namespace lueur::cli {

struct CompareJob {
  std::string scene;
  LoadLimits limits;
  FrameOptions frame;  // as typed
  FrameSetup setup;
  std::vector<ChosenTechnique> techniques;  // at least one
  std::vector<ChosenReference> references;
  uint32_t frames = 0;  // timed, of each technique
  reference::Cache cache = reference::Cache::use;
  std::filesystem::path folder;
  std::string command;  // what reproduces it
  bool json = false;
};

// Traces the references, renders and times the techniques, writes the page and its tables, and
// prints the errors. kExitInterrupted, and nothing written, after SIGINT or SIGTERM while it
// traces; from then on they end the process, also with nothing half-written.
Outcome run_compare(CompareJob& job);

}  // namespace lueur::cli
