// SPDX-License-Identifier: MIT
#include "destination.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/try.h"
#include "image/exr.h"
#include "image/png.h"
#include "picture.h"

namespace lueur::cli {
namespace fs = std::filesystem;
namespace {

Error cannot_write(const fs::path& path, const std::string& reason) {
  return {ErrorKind::output, path.string() + ": cannot be written: " + reason};
}

Result<void> check_folder(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found)
    return cannot_write(path, "the folder " + folder.string() + " does not exist; make it first");
  if (error) return cannot_write(path, folder.string() + ": " + error.message());
  if (!fs::is_directory(status)) return cannot_write(path, folder.string() + " is not a folder");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return cannot_write(path, folder.string() + ": " + std::strerror(errno));
  return {};
}

Result<Destination> check_destination(const std::string& text, Extent size) {
  const Destination destination = destination_of(text);
  const uint64_t pixels = uint64_t{size.width} * size.height;
  uint64_t most_pixels = kMaxPngPixels;
  if (destination.kind == FileKind::exr) {
    most_pixels = kMaxExrSamples / kExrChannels;
  } else if (ending_of(destination.path) != ".png") {
    return Error{ErrorKind::usage, "-o '" + text + "': the name has to end in .png or .exr"};
  }
  if (pixels > most_pixels)
    return Error{ErrorKind::usage, "-o '" + text + "': " + std::to_string(pixels) +
                                       " pixels do not fit into this format; choose a --size of " +
                                       std::to_string(most_pixels) + " pixels or fewer"};
  LUEUR_TRY_VOID(check_writable(destination.path));
  return destination;
}

}  // namespace

Destination destination_of(const fs::path& path) {
  return {path, ending_of(path) == ".exr" ? FileKind::exr : FileKind::png};
}

Result<std::vector<Destination>> check_destinations(const std::vector<std::string>& paths,
                                                    Extent size) {
  std::vector<Destination> destinations;
  for (const std::string& text : paths) {
    LUEUR_TRY(destination, check_destination(text, size));
    const bool twice =
        std::any_of(destinations.begin(), destinations.end(),
                    [&](const Destination& other) { return other.path == destination.path; });
    if (twice) return Error{ErrorKind::usage, "-o '" + text + "' is given twice; give it once"};
    destinations.push_back(destination);
  }
  return destinations;
}

Result<void> check_writable(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return cannot_write(path, "it is a folder; name a file in it");
  return check_folder(path, path.has_parent_path() ? path.parent_path() : fs::path("."));
}

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error && !fs::is_directory(folder)) return cannot_write(folder, error.message());
  return check_folder(folder, folder);
}

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

}  // namespace lueur::cli
