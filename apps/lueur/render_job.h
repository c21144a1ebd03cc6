// SPDX-License-Identifier: MIT
// What `lueur render` is to do, all of it checked, and the doing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "commands.h"
#include "destination.h"
#include "frame_names.h"
#include "frame_options.h"
#include "image/tone_map.h"
#include "moving_shot.h"
#include "scene/gltf_load.h"
#include "technique_list.h"

namespace lueur::cli {

struct RenderJob {
  std::string scene;
  LoadLimits limits;
  std::string camera;                     // name or number; empty: the first
  std::vector<std::string> side_cameras;  // the same
  FrameSetup setup;
  Pace pace;  // a single picture is its frame 0
  ChosenTechnique technique;

  ExposureChoice exposure;
  ToneMap tone_map = ToneMap::khronos_neutral;
  std::string tone_map_name;

  std::vector<Destination> destinations;  // of a single picture
  std::optional<FrameRange> frames;       // of an animation
  uint32_t settle = 0;                    // frames before those, which are not written
  FrameOutputs frame_outputs;
  std::string view;               // "pass.image" to write there; empty: the picture
  std::vector<std::string> dump;  // patterns
  std::string dump_to;            // folder

  bool json = false;
  bool list_views = false;
  bool scan = false;
  bool validate = false;
  std::string device;
};

// Renders, writes, reports. kExitFinding when a scan or the validation found something,
// kExitInterrupted when frames are left out.
Outcome run_render(RenderJob& job);

}  // namespace lueur::cli
