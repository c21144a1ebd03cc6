// SPDX-License-Identifier: MIT
// Techniques for indirect light side by side with each other and with references: what was rendered
// and measured, and the page and tables that are made of it. Fill a Comparison and write it.
//
// Everything that is written is a function of the Comparison alone: there is no date, and the same
// input gives the same bytes. Text may hold anything; bytes that are not UTF-8 are replaced.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/tone_map.h"
#include "lueur/result.h"

namespace lueur::report {

using Json = nlohmann::ordered_json;

// One rendering. An image without pixels is one that does not exist; the page leaves it out.
struct Pictures {
  // Linear and scene-referred, 3 channels.
  ImageF composed;     // what the camera sees: direct + albedo * indirect + specular
  ImageF indirect;     // the indirect light alone: E/pi, before albedo
  ImageF occlusion{};  // 1 channel: 1 open, 0 closed
};

// Which values of a metric are better.
enum class Better : uint8_t { lower, higher, nearer_zero };

// A column of the error tables.
struct Metric {
  std::string name;   // as in results.json and results.csv, e.g. "rel_mse"
  std::string label;  // as in a heading, e.g. "relMSE"
  std::string unit;   // empty for a pure number
  Better better = Better::lower;
  std::string summary;  // one sentence, shown beside the heading
};

// rmse, rel_mse, psnr, ssim, flip, bias and rmse_scaled, in this order.
std::vector<Metric> standard_metrics();

struct ErrorValue {
  std::string metric;  // the name of one of the comparison's metrics
  double value = 0.0;  // not finite: there is none, e.g. the PSNR of equal pictures
};

// An error for each pixel.
struct ErrorMap {
  std::string metric;
  ImageF image;             // 1 channel, 0 or more
  double full_scale = 1.0;  // the error that the page shows brightest at first; above 0
};

// An entry held against one reference.
struct Errors {
  std::string reference;  // the label of one of the comparison's references
  std::vector<ErrorValue> values;
  std::vector<ErrorMap> maps;
};

struct Pass {
  std::string
      name;         // e.g. "hierarchical.gather@0"; what follows '@' tells passes of one kind apart
  double ms = 0.0;  // median
};

// A technique with its settings.
struct Entry {
  std::string label;      // as the page names it, e.g. "hierarchical, samples 32"
  std::string technique;  // its name; entries of one technique are joined in the plot
  Json settings = Json::object();
  double technique_ms = 0.0;  // median; 0 where there is no technique
  double frame_ms = 0.0;      // median of the whole frame
  std::vector<Pass> passes;   // in the order in which they ran
  Pictures pictures;
  std::vector<Errors> errors;
};

// What is taken as the truth.
struct Reference {
  std::string label;  // different from all others
  std::string mode;   // how it was computed, e.g. "path"
  uint32_t samples_per_pixel = 0;
  std::optional<double> relative_error;  // estimated, of the picture as a whole; 0.01 is 1 %
  double seconds = 0.0;
  Pictures pictures;
};

struct Comparison {
  std::string title;
  std::string scene;    // as on the command line
  std::string camera;   // its name, or how it was placed
  uint32_t width = 0;   // pixels, of every picture and map
  uint32_t height = 0;  // pixels
  std::string device;
  double exposure_ev = 0.0;
  ToneMap tone_map = ToneMap::khronos_neutral;
  std::string command;  // reproduces everything
  std::vector<std::string> warnings;
  std::vector<Metric> metrics = standard_metrics();
  std::vector<Reference> references;
  std::vector<Entry> entries;
  ImageF direct;  // direct light only, composed; may be missing
};

// Writes three files into `folder`, which is made where it is missing. Each is all or nothing:
//   results.json  everything but the pictures, see README.md of this folder
//   results.csv   a row for each entry and reference, a column for each metric
//   index.html    the page, with pictures; needs no network and no other file
// Checks that pictures have the comparison's size and that names of metrics and references exist.
// Fails (ErrorKind::output) where the folder or a file cannot be written.
Result<void> write_comparison(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace lueur::report
