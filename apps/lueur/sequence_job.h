// SPDX-License-Identifier: MIT
// What `lueur sequence` is to do, all of it checked, and the doing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "commands.h"
#include "frame_options.h"
#include "scene/gltf_load.h"
#include "sequence.h"
#include "technique_list.h"

namespace lueur::cli {

enum class Hold { nothing, camera, scene };

struct SequenceJob {
  std::string scene;
  LoadLimits limits;
  FrameOptions frame;  // as typed
  Sequence sequence;
  Hold hold = Hold::nothing;                // stands still as at the sequence's beginning
  std::vector<ChosenTechnique> techniques;  // at least one
  std::filesystem::path folder;             // for the frames; empty: they are not kept
  bool json = false;
};

// Renders the sequence with each technique, writes the frames, and prints flicker and ghosts.
Outcome run_sequence(SequenceJob& job);

}  // namespace lueur::cli
