// SPDX-License-Identifier: MIT
// What `lueur scene sheet` is to do, all of it checked, and the doing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "commands.h"
#include "lueur/image.h"
#include "scene/load_limits.h"
#include "scene_files.h"
#include "technique_list.h"

namespace lueur::cli {

struct SheetJob {
  std::vector<SceneSource> scenes;
  ChosenTechnique technique;
  Extent size;
  float time_s = 0;
  bool all_cameras = false;  // else the first of each scene
  LoadLimits limits;         // of each scene
  std::string device;
  std::filesystem::path page;
  std::string command;  // that makes the page again
  bool json = false;
};

// Draws the scenes one after the other on one device, writes the page, and says what it has drawn.
// A scene that cannot be loaded or drawn is listed and does not stop the others; when none can be
// drawn, nothing is written and the outcome is an error. kExitInterrupted, and nothing written,
// after SIGINT or SIGTERM.
Outcome run_sheet(SheetJob& job);

}  // namespace lueur::cli
