// SPDX-License-Identifier: MIT
#include "report/figure_page.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/file.h"
#include "base/try.h"
#include "image/png.h"
#include "report/folder.h"
#include "report/page.h"
#include "report/page_sources.h"
#include "report/text.h"

namespace lueur::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// Turns blocks into JSON, one overload for each kind; with data URLs of pictures where they are
// wanted.
struct BlockWriter {
  bool with_pictures = false;

  Result<Json> operator()(const Paragraph& paragraph) const {
    return Json{{"kind", "paragraph"}, {"text", paragraph.text}};
  }

  Result<Json> operator()(const PictureRow& row) const {
    Json pictures = Json::array();
    for (const Picture& picture : row.pictures) {
      LUEUR_TRY(json, picture_json(picture));
      pictures.push_back(std::move(json));
    }
    return Json{{"kind", "pictures"}, {"caption", row.caption}, {"pictures", std::move(pictures)}};
  }

  Result<Json> operator()(const Table& table) const {
    Json columns = Json::array();
    for (const Column& column : table.columns)
      columns.push_back({{"heading", column.heading},
                         {"unit", column.unit},
                         {"group", column.group},
                         {"digits", column.digits}});
    Json rows = Json::array();
    for (const std::vector<Cell>& cells : table.rows) {
      LUEUR_CHECK_OP(cells.size(), ==, table.columns.size());
      Json row = Json::array();
      for (const Cell& cell : cells) row.push_back(cell_json(cell));
      rows.push_back(std::move(row));
    }
    return Json{{"kind", "table"},
                {"caption", table.caption},
                {"columns", std::move(columns)},
                {"rows", std::move(rows)}};
  }

  Result<Json> operator()(const Plot& plot) const {
    Json curves = Json::array();
    for (const Curve& curve : plot.curves) {
      Json points = Json::array();
      for (const auto& [x, y] : curve.points) points.push_back({number(x), number(y)});
      curves.push_back(
          {{"label", curve.label}, {"dashed", curve.dashed}, {"points", std::move(points)}});
    }
    return Json{{"kind", "plot"},
                {"caption", plot.caption},
                {"x", {{"label", plot.x.label}, {"log", plot.x.logarithmic}}},
                {"y", {{"label", plot.y.label}, {"log", plot.y.logarithmic}}},
                {"curves", std::move(curves)}};
  }

 private:
  Result<Json> picture_json(const Picture& picture) const {
    Json marks = Json::array();
    for (const Mark& mark : picture.marks)
      marks.push_back({mark.x0_px, mark.y0_px, mark.x1_px, mark.y1_px});
    Json json = {{"caption", picture.caption},
                 {"size", {picture.image.width, picture.image.height}},
                 {"marks", std::move(marks)}};
    if (with_pictures) {
      LUEUR_TRY(png, encode_png(picture.image, "the picture \"" + picture.caption + '"'));
      json["url"] = "data:image/png;base64," + base64(png);
    }
    return json;
  }

  static Json cell_json(const Cell& cell) {
    if (const auto* value = std::get_if<double>(&cell)) return number(*value);
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    return nullptr;
  }
};

Result<Json> page_json(const FigurePage& page, const BlockWriter& writer) {
  Json facts = Json::array();
  for (const auto& [name, value] : page.facts) facts.push_back({name, value});
  Json sections = Json::array();
  for (const FigureSection& section : page.sections) {
    Json blocks = Json::array();
    for (const Block& block : section.blocks) {
      LUEUR_TRY(json, std::visit(writer, block));
      blocks.push_back(std::move(json));
    }
    sections.push_back({{"title", section.title}, {"blocks", std::move(blocks)}});
  }
  return Json{{"title", page.title},       {"summary", page.summary},
              {"facts", std::move(facts)}, {"command", page.command},
              {"warnings", page.warnings}, {"sections", std::move(sections)}};
}

}  // namespace

Result<Json> figures_json(const FigurePage& page) {
  return page_json(page, {.with_pictures = false});
}

Result<void> write_figure_page(const FigurePage& page, const std::filesystem::path& folder) {
  LUEUR_TRY(numbers, figures_json(page));
  LUEUR_TRY(data, page_json(page, {.with_pictures = true}));
  LUEUR_TRY_VOID(make_folder(folder));
  LUEUR_TRY_VOID(write_file(folder / "figures.json", json_file(numbers)));
  return write_file(folder / "index.html",
                    page_html({.title = page.title,
                               .skeleton = kFigureSkeleton,
                               .styles = {kBaseStyle},
                               .scripts = {kFigureScripts.begin(), kFigureScripts.end()},
                               .data = std::move(data),
                               .packed_pictures = {}}));
}

}  // namespace lueur::report
