// SPDX-License-Identifier: MIT
#include "scene_files.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "arguments.h"
#include "base/try.h"
#include "scene/builtin/builtin.h"
#include "scene/scene_file.h"
#include "session.h"

namespace lueur::cli {
namespace fs = std::filesystem;
namespace {

bool is_scene_file(const fs::directory_entry& entry) {
  std::error_code error;
  return has_scene_ending(entry.path()) && entry.is_regular_file(error);
}

// The folder's own name, also where it was typed as "." or with a slash at its end.
fs::path name_of(const fs::path& folder) {
  std::error_code error;
  const fs::path full = fs::canonical(folder, error);
  return error ? folder : full.filename();
}

// Folders below that may not be read are passed over, but not the one that was asked for.
Result<std::vector<SceneSource>> search(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  const fs::directory_iterator readable(folder, error);
  if (!error) {
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
      if (is_scene_file(*entry)) paths.push_back(entry->path());
  }
  if (error) return Error{ErrorKind::input, folder + ": cannot be searched: " + error.message()};
  if (paths.empty())
    return Error{ErrorKind::input, folder + ": no scene files in it (" +
                                       std::string(kSceneFileEndings) + "); name another folder"};
  std::sort(paths.begin(), paths.end());
  std::vector<SceneSource> sources;
  for (const fs::path& path : paths)
    sources.push_back(
        {path.string(), (name_of(folder) / path.lexically_relative(folder)).string()});
  return sources;
}

}  // namespace

Result<std::vector<SceneSource>> find_scenes(const std::vector<std::string>& arguments) {
  std::vector<SceneSource> sources;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (is_builtin(argument) || !fs::is_directory(argument, error)) {
      sources.push_back({argument, argument});
      continue;
    }
    LUEUR_TRY(found, search(argument));
    sources.insert(sources.end(), found.begin(), found.end());
  }
  if (arguments.empty())
    for (const BuiltinScene& scene : builtin_scenes())
      sources.push_back({std::string(scene.name), std::string(scene.name)});
  return sources;
}

}  // namespace lueur::cli
