// SPDX-License-Identifier: MIT
// A contact sheet: many scenes on one page, a small picture or several of each, and the files that
// could not be drawn. As with a comparison, there is no date and the same input gives the same
// bytes, and text may hold anything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "lueur/result.h"

namespace lueur::report {

struct SheetPicture {
  std::string camera;
  float exposure_ev = 0.0f;
  std::vector<uint8_t> png;  // a whole file: packed, hundreds of pictures fit into memory
};

struct SheetScene {
  std::string name;
  std::string source;  // where it came from; shown where it is not the name
  uint64_t triangles = 0;
  double load_ms = 0.0;
  std::vector<std::string> warnings;
  std::vector<SheetPicture> pictures;  // one for each camera that was asked for
};

struct SheetRefusal {
  std::string source;
  std::string reason;  // one line
};

struct Sheet {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  // e.g. {"device", "llvmpipe"}
  std::string command;                                     // reproduces everything
  uint32_t width = 0;                                      // of all pictures, in pixels
  uint32_t height = 0;
  std::vector<SheetScene> scenes;
  std::vector<SheetRefusal> refused;
};

// Writes the page, all or nothing; it needs no network and no other file. Fails
// (ErrorKind::output) where the file cannot be written.
Result<void> write_sheet(const Sheet& sheet, const std::filesystem::path& path);

}  // namespace lueur::report
