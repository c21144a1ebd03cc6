// SPDX-License-Identifier: MIT
#include "report/sheet.h"

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "report/page.h"
#include "report/page_sources.h"
#include "report/text.h"

namespace lueur::report {
namespace {

using Json = nlohmann::ordered_json;

// The script counts pictures in the same order as page_html() gets them.
Json scene_json(const SheetScene& scene) {
  Json pictures = Json::array();
  for (const SheetPicture& picture : scene.pictures)
    pictures.push_back({{"camera", picture.camera}, {"exposure_ev", picture.exposure_ev}});
  return {{"name", scene.name},           {"source", scene.source},
          {"triangles", scene.triangles}, {"load_ms", scene.load_ms},
          {"warnings", scene.warnings},   {"pictures", std::move(pictures)}};
}

Json sheet_json(const Sheet& sheet) {
  Json facts = Json::array();
  for (const auto& [name, value] : sheet.facts) facts.push_back({name, value});
  Json scenes = Json::array();
  for (const SheetScene& scene : sheet.scenes) scenes.push_back(scene_json(scene));
  Json refused = Json::array();
  for (const SheetRefusal& refusal : sheet.refused)
    refused.push_back({{"source", refusal.source}, {"reason", refusal.reason}});
  return {{"title", sheet.title},
          {"facts", std::move(facts)},
          {"warnings", Json::array()},
          {"command", sheet.command},
          {"size", {sheet.width, sheet.height}},
          {"scenes", std::move(scenes)},
          {"refused", std::move(refused)}};
}

}  // namespace

Result<void> write_sheet(const Sheet& sheet, const std::filesystem::path& path) {
  Page page{.title = sheet.title,
            .skeleton = kSheetSkeleton,
            .styles = {kBaseStyle, kSheetStyle},
            .scripts = {kSheetScripts.begin(), kSheetScripts.end()},
            .data = sheet_json(sheet),
            .packed_pictures = {}};
  for (const SheetScene& scene : sheet.scenes)
    for (const SheetPicture& picture : scene.pictures)
      page.packed_pictures.push_back(base64(picture.png));
  return write_file(path, page_html(page));
}

}  // namespace lueur::report
