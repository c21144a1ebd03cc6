// SPDX-License-Identifier: MIT
// Scenes by the dozen: what a list of names, files and folders stands for.
#pragma once

#include <string>
#include <vector>

#include "lueur/result.h"

namespace lueur::cli {

struct SceneSource {
  std::string spec;   // what load_scene() takes
  std::string label;  // for people: `spec`, or a file's path from the folder that was searched
};

// For each argument in turn: the scene files in a folder and below it, sorted by path; anything
// else as it is, whether there is such a scene or not. For no argument, every built-in scene. A
// built-in name wins over a folder of that name, and links to folders are not followed. Fails
// (ErrorKind::input) on a folder that cannot be read or has no scene file in it.
Result<std::vector<SceneSource>> find_scenes(const std::vector<std::string>& arguments);

}  // namespace lueur::cli
