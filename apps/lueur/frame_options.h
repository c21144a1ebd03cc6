// SPDX-License-Identifier: MIT
// Options that several commands take, each with one name, one default and one line of help.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "environment_choice.h"
#include "lueur/image.h"
#include "lueur/result.h"
#include "technique_list.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace lueur::cli {

// What was typed, before it is checked. The options write into it when the command line is read.
struct FrameOptions {
  std::string size = "1280x720";
  std::string camera;
  std::vector<std::string> side_cameras;
  std::string seed = "0";
  EnvironmentOptions environment;
  std::string device;
};
struct TechniqueOptions {
  std::string name = "hierarchical";
  std::string preset;
  std::vector<std::string> settings;
};

// --size, --camera, --seed, --env and its like: what is looked at, also without a device.
void add_view_options(CLI::App& command, FrameOptions& options);
// Those, --side-camera and --device.
void add_frame_options(CLI::App& command, FrameOptions& options);

// --technique, --preset, --set.
void add_technique_options(CLI::App& command, TechniqueOptions& options);
Result<ChosenTechnique> check(const TechniqueOptions& options);

// --object, which writes its file into `scene` as that parameter of a built-in scene. To be added
// after the option that fills `scene`.
void add_object_option(CLI::App& command, std::string& scene);

// The positional argument SCENE, which is required, and --object.
void add_scene_argument(CLI::App& command, std::string& scene);

struct FrameSetup {
  Extent size;
  uint32_t seed = 0;
  EnvironmentChoice environment;
};
Result<FrameSetup> check(const FrameOptions& options);

}  // namespace lueur::cli
