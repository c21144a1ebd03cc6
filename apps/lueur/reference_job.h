// SPDX-License-Identifier: MIT
// What `lueur reference` is to do, all of it checked, and the doing.
#pragma once

#include <string>
#include <vector>

#include "arguments.h"
#include "commands.h"
#include "destination.h"
#include "environment_choice.h"
#include "image/tone_map.h"
#include "reference/rendering_file.h"
#include "scene/gltf_load.h"

namespace lueur::cli {

struct ReferenceJob {
  std::string scene;
  LoadLimits limits;
  std::string camera;  // name or number; empty: the first
  reference::Shot shot;
  reference::Settings settings;
  EnvironmentChoice environment;
  uint32_t threads = 0;
  bool resume = false;
  reference::Cache cache = reference::Cache::use;

  ExposureChoice exposure;
  ToneMap tone_map = ToneMap::khronos_neutral;
  std::vector<Destination> destinations;  // at least one
  bool json = false;
};

// Where an interrupted rendering keeps what continues it: beside the first picture.
std::filesystem::path state_path(const ReferenceJob& job);

// Traces, writes, reports. kExitInterrupted after SIGINT or SIGTERM, with what there was written.
Outcome run_reference(ReferenceJob& job);

}  // namespace lueur::cli
