// SPDX-License-Identifier: MIT
// Where pictures go. Everything that can be known of a path is checked before anything is rendered,
// so that a typing mistake costs no time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lueur/image.h"
#include "lueur/result.h"

namespace lueur::cli {

enum class FileKind { png, exr };

struct Destination {
  std::filesystem::path path;
  FileKind kind = FileKind::png;
};

// By the path's ending: .exr, or else a PNG.
Destination destination_of(const std::filesystem::path& path);

// The paths of -o. Fails with ErrorKind::usage on endings other than .png and .exr, a path given
// twice and a picture too large for its format, with ErrorKind::output on folders that are missing
// or not writable.
Result<std::vector<Destination>> check_destinations(const std::vector<std::string>& paths,
                                                    Extent size);

// Checks the folder of one file, and that the path itself is not a folder.
Result<void> check_writable(const std::filesystem::path& path);

// Makes the folder where it is missing, and checks that files can be written into it.
Result<void> make_folder(const std::filesystem::path& folder);

// The path's ending in lower case, with its dot.
std::string ending_of(const std::filesystem::path& path);

}  // namespace lueur::cli
