// SPDX-License-Identifier: MIT
// A page of figures: captioned pictures, tables and line plots, in sections. For results that are
// held against a paper's. As with a comparison, there is no date and the same input gives the same
// bytes, and text may hold anything.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "image/image.h"
#include "lueur/result.h"

namespace lueur::report {

struct Paragraph {
  std::string text;
};

// A line drawn over a picture, e.g. where a slice was taken. In pixels from the top left corner.
struct Mark {
  double x0_px = 0.0;
  double y0_px = 0.0;
  double x1_px = 0.0;
  double y1_px = 0.0;
};

struct Picture {
  Image8 image;         // display-referred, see to_display()
  std::string caption;  // also what a reader hears who does not see the picture
  std::vector<Mark> marks;
};

// Pictures side by side, as many to a line as there is room for.
struct PictureRow {
  std::vector<Picture> pictures;
  std::string caption;  // of all; may be empty
};

// Columns next to each other of one group, e.g. "paper" or "ours", share a heading above theirs.
struct Column {
  std::string heading;
  std::string unit;
  std::string group;
  int digits = 3;  // of its largest number
};

using Cell = std::variant<std::monostate, double, std::string>;  // nothing is shown as a dash

// The first cell of each row names it. Numbers of one column have equally many decimals.
struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as `columns`
};

struct Axis {
  std::string label;         // with its unit
  bool logarithmic = false;  // points at or below 0 are left out then
};

struct Curve {
  std::string label;
  std::vector<std::pair<double, double>> points;  // x and y, joined in this order
  bool dashed = false;                            // e.g. for a reference
};

struct Plot {
  std::string caption;
  Axis x;
  Axis y;
  std::vector<Curve> curves;
};

using Block = std::variant<Paragraph, PictureRow, Table, Plot>;

struct FigureSection {
  std::string title;
  std::vector<Block> blocks;
};

struct FigurePage {
  std::string title;
  std::string summary;                                     // a paragraph below the title
  std::vector<std::pair<std::string, std::string>> facts;  // e.g. {"device", "llvmpipe"}
  std::string command;                                     // reproduces everything
  std::vector<std::string> warnings;
  std::vector<FigureSection> sections;
};

// figures.json: everything but the pictures.
Result<nlohmann::ordered_json> figures_json(const FigurePage& page);

// Writes two files into `folder`, which is made where it is missing. Each is all or nothing:
//   figures.json  everything but the pictures
//   index.html    the page; needs no network and no other file
// Fails (ErrorKind::output) where the folder or a file cannot be written, and for pictures that
// cannot be encoded (see encode_png()).
Result<void> write_figure_page(const FigurePage& page, const std::filesystem::path& folder);

}  // namespace lueur::report
