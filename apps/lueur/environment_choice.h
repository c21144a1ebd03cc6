// SPDX-License-Identifier: MIT
// The environment that a command line puts around a scene.
#pragma once

#include <string>
#include <vector>

#include "lueur/result.h"
#include "scene/environment.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace lueur::cli {

// What was typed.
struct EnvironmentOptions {
  std::string file;
  std::string rotation_deg;
  std::string intensity;
};

struct EnvironmentChoice {
  std::string file;  // empty: none but the scene's own
  float rotation_rad = 0;
  float intensity = 1;
};

// --env, --env-rotation, --env-intensity.
void add_environment_options(CLI::App& command, EnvironmentOptions& options);
Result<EnvironmentChoice> check(const EnvironmentOptions& options);

// Reads the picture, OpenEXR or Radiance by its content; samples that are no radiance become 0 or
// the largest there is, with a line in `warnings`. Fails (ErrorKind::input) where the readers do,
// and on an EXR without a main picture.
Result<Environment> load_environment(const EnvironmentChoice& choice,
                                     std::vector<std::string>& warnings);

}  // namespace lueur::cli
