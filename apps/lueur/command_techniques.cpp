// SPDX-License-Identifier: MIT
// lueur techniques: each technique and its settings, read from the library's own tables.
#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>

#include "base/check.h"
#include "base/try.h"
#include "commands.h"
#include "console.h"
#include "json_output.h"

namespace lueur::cli {
namespace {

// "1 to 256 samples", "full, half or quarter", "true or false".
std::string range_text(const SettingInfo& row) {
  if (row.kind == SettingKind::toggle) return "true or false";
  std::ostringstream text;
  if (row.kind == SettingKind::choice) {
    for (size_t i = 0; i < row.choices.size(); ++i)
      text << (i == 0 ? "" : i + 1 == row.choices.size() ? " or " : ", ") << row.choices[i];
    return text.str();
  }
  text << row.min << " to " << row.max;
  if (!row.unit.empty()) text << " " << row.unit;
  return text.str();
}

Json setting_json(const SettingInfo& row, const void* settings) {
  constexpr const char* kKinds[] = {"integer", "real", "choice", "toggle"};
  Json json = {{"name", row.name},
               {"kind", kKinds[static_cast<size_t>(row.kind)]},
               {"default", setting_value(row, settings)}};
  if (row.kind == SettingKind::integer || row.kind == SettingKind::real) {
    json["min"] = row.min;
    json["max"] = row.max;
  }
  if (row.kind == SettingKind::choice) json["choices"] = row.choices;
  json["unit"] = row.unit;
  json["summary"] = row.summary;
  return json;
}

// Its settings, each as JSON's own kind.
Json preset_json(const TechniqueInfo& info, const Preset& preset) {
  const auto technique = info.make();
  LUEUR_CHECK(apply_preset(info, preset.name, technique->settings()).ok());
  Json settings = Json::object();
  for (const auto& [name, text] : preset.settings)
    for (const SettingInfo& row : info.settings)
      if (row.name == name) settings[std::string(name)] = setting_value(row, technique->settings());
  return {{"name", preset.name}, {"summary", preset.summary}, {"settings", settings}};
}

std::string as_text() {
  std::ostringstream out;
  for (const TechniqueInfo& info : techniques()) {
    const auto technique = info.make();
    out << info.name << ": " << info.summary << "\n  " << info.source << "\n";
    if (!info.diffuse_alpha.empty()) out << "  EXR layer " << info.diffuse_alpha << "\n";
    for (const SettingInfo& row : info.settings)
      out << "  --set " << row.name << "=" << to_text(row, technique->settings()) << "  ("
          << range_text(row) << ")\n      " << row.summary << "\n";
    for (const Preset& preset : info.presets) {
      out << "  --preset " << preset.name << "\n      " << preset.summary;
      for (const auto& [name, text] : preset.settings) out << " " << name << "=" << text;
      out << "\n";
    }
  }
  return out.str();
}

Json as_json() {
  Json list = Json::array();
  for (const TechniqueInfo& info : techniques()) {
    const auto technique = info.make();
    Json settings = Json::array();
    for (const SettingInfo& row : info.settings)
      settings.push_back(setting_json(row, technique->settings()));
    Json presets = Json::array();
    for (const Preset& preset : info.presets) presets.push_back(preset_json(info, preset));
    list.push_back({{"name", info.name},
                    {"summary", info.summary},
                    {"source", info.source},
                    {"diffuse_alpha", info.diffuse_alpha},
                    {"settings", settings},
                    {"presets", presets}});
  }
  return {{"techniques", list}};
}

Outcome run(bool json) {
  LUEUR_TRY_VOID(json ? print_json(as_json()) : print_data(as_text()));
  return kExitDone;
}

}  // namespace

void add_techniques(CLI::App& program, Outcome& outcome) {
  CLI::App* command =
      program.add_subcommand("techniques", "List the techniques and their settings");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One JSON object on stdout");
  command->footer(std::string("Examples:\n"
                              "  lueur techniques\n"
                              "  lueur render atrium --technique hierarchical --set samples=32 "
                              "-o atrium.png\n") +
                  kExitCodes);
  command->callback([json, &outcome] { outcome = run(*json); });
}

}  // namespace lueur::cli
