// SPDX-License-Identifier: MIT
// lueur scene sheet: many scenes on one page.
#include <CLI/CLI.hpp>
#include <memory>

#include "arguments.h"
#include "base/try.h"
#include "destination.h"
#include "frame_options.h"
#include "image/png.h"
#include "limit_option.h"
#include "sheet_job.h"

namespace lueur::cli {
namespace {

struct SheetOptions {
  std::vector<std::string> scenes;
  std::string page;
  std::string size = "480x270";
  std::string time_s = "0";
  std::string device;
  TechniqueOptions technique;
  LoadLimits limits;
  bool all_cameras = false;
  bool json = false;
};

// Everything that decides the result, defaults included, so that it holds for later versions, too.
std::string command_of(const SheetOptions& options) {
  std::string command = "lueur scene sheet";
  for (const std::string& scene : options.scenes) command += " " + shell_quoted(scene);
  const auto add = [&](const char* flag, const std::string& value) {
    command += std::string(" ") + flag + " " + shell_quoted(value);
  };
  add("--technique", options.technique.name);
  if (!options.technique.preset.empty()) add("--preset", options.technique.preset);
  for (const std::string& setting : options.technique.settings) add("--set", setting);
  add("--size", options.size);
  add("--time", options.time_s);
  if (options.all_cameras) command += " --all-cameras";
  add("-o", options.page);
  return command;
}

Result<SheetJob> check(const SheetOptions& options) {
  SheetJob job;
  if (ending_of(options.page) != ".html")
    return Error{ErrorKind::usage, "-o '" + options.page + "': the name has to end in .html"};
  job.page = options.page;
  LUEUR_TRY(size, parse_size("--size", options.size));
  job.size = size;
  if (uint64_t{size.width} * size.height > kMaxPngPixels)
    return Error{ErrorKind::usage, "--size '" + options.size + "': a picture has at most " +
                                       std::to_string(kMaxPngPixels) + " pixels"};
  LUEUR_TRY(time_s, parse_real("--time", options.time_s, 1e6f));
  job.time_s = time_s;
  LUEUR_TRY(technique, check(options.technique));
  job.technique = std::move(technique);
  job.all_cameras = options.all_cameras;
  job.device = options.device;
  job.limits = options.limits;
  job.json = options.json;
  job.command = command_of(options);
  LUEUR_TRY_VOID(check_writable(job.page));
  LUEUR_TRY(scenes, find_scenes(options.scenes));
  job.scenes = std::move(scenes);
  return job;
}

Outcome run(const SheetOptions& options) {
  LUEUR_TRY(job, check(options));
  return run_sheet(job);
}

constexpr char kSheetFooter[] =
    "SCENE is a built-in scene, a scene file, or a folder, which is searched with all folders\n"
    "below it for .gltf, .glb and .obj files; without one, all built-in scenes are drawn.\n"
    "\n"
    "Writes a page that needs no network and no other file: a picture of each scene with its\n"
    "name, triangles, time to load and warnings, and below them what could not be drawn and why.\n"
    "Such files do not fail the command unless nothing at all can be drawn. Each picture has the\n"
    "exposure that `lueur render` gives it. Interrupted, it writes nothing.\n"
    "\n"
    "Examples:\n"
    "  lueur scene sheet -o builtin.html\n"
    "  lueur scene sheet models -o models.html\n"
    "  lueur scene sheet models room.glb --technique none --size 320x180 --json -o sheet.html\n";

}  // namespace

void add_scene_sheet(CLI::App& scene, Outcome& outcome) {
  CLI::App* command = scene.add_subcommand("sheet", "Draw many scenes on one page");
  auto options = std::make_shared<SheetOptions>();
  command
      ->add_option("SCENE", options->scenes,
                   "Built-in scenes, files, folders (default: all built-in)")
      ->type_name("");
  command->add_option("-o,--output", options->page, "The page, .html")
      ->type_name("FILE")
      ->required();
  command->add_option("--size", options->size, "Of each picture (default 480x270)")
      ->type_name("WxH");
  command->add_option("--time", options->time_s, "Seconds into the animation (default 0)")
      ->type_name("SECONDS");
  command->add_flag("--all-cameras", options->all_cameras, "A picture for each camera");
  add_technique_options(*command, options->technique);
  add_limit_option(*command, options->limits);
  command->add_option("--device", options->device, "Number or name, see `lueur devices`")
      ->type_name("N|NAME");
  command->add_flag("--json", options->json, "Report as one JSON object on stdout");
  command->footer(std::string(kSheetFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
