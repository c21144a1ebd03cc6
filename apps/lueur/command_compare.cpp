// SPDX-License-Identifier: MIT
// lueur compare: techniques side by side with the truth, as a page and tables.
#include <CLI/CLI.hpp>
#include <memory>

#include "arguments.h"
#include "base/try.h"
#include "compare_job.h"
#include "destination.h"
#include "limit_option.h"

namespace lueur::cli {
namespace {

struct CompareOptions {
  std::string scene;
  LoadLimits limits;
  std::string techniques = "hierarchical,none";
  std::string references = "path";
  std::string spp = "256";
  std::string bounces = "1";
  std::string frames = "10";
  FrameOptions frame{.size = "640x360"};
  std::string folder;
  bool no_cache = false;
  bool json = false;
};

// Everything that decides the result, defaults included, so that it holds for later versions, too.
std::string command_of(const CompareOptions& options) {
  std::string command = "lueur compare " + shell_quoted(options.scene);
  const auto add = [&](const char* flag, const std::string& value) {
    command += std::string(" ") + flag + " " + shell_quoted(value);
  };
  add("--techniques", options.techniques);
  add("--reference", options.references);
  add("--size", options.frame.size);
  if (!options.frame.camera.empty()) add("--camera", options.frame.camera);
  for (const std::string& camera : options.frame.side_cameras) add("--side-camera", camera);
  const EnvironmentOptions& environment = options.frame.environment;
  if (!environment.file.empty()) add("--env", environment.file);
  if (!environment.rotation_deg.empty()) add("--env-rotation", environment.rotation_deg);
  if (!environment.intensity.empty()) add("--env-intensity", environment.intensity);
  add("--spp", options.spp);
  add("--bounces", options.bounces);
  add("--seed", options.frame.seed);
  add("--frames", options.frames);
  add("-o", options.folder);
  return command;
}

Result<CompareJob> check(const CompareOptions& options) {
  CompareJob job;
  job.scene = options.scene;
  job.limits = options.limits;
  job.frame = options.frame;
  if (options.no_cache) job.cache = reference::Cache::ignore;
  job.json = options.json;
  job.command = command_of(options);
  LUEUR_TRY(setup, check(options.frame));
  job.setup = setup;
  LUEUR_TRY(techniques, choose_techniques("--techniques", options.techniques));
  job.techniques = std::move(techniques);
  reference::Settings defaults;
  LUEUR_TRY_VOID(set_reference(defaults, "--", "spp", options.spp));
  LUEUR_TRY_VOID(set_reference(defaults, "--", "bounces", options.bounces));
  LUEUR_TRY(references, choose_references("--reference", options.references, defaults));
  job.references = std::move(references);
  LUEUR_TRY(frames, parse_count("--frames", options.frames, 1, 10000));
  job.frames = frames;
  job.folder = options.folder;
  LUEUR_TRY_VOID(make_folder(job.folder));
  return job;
}

Outcome run(const CompareOptions& options) {
  LUEUR_TRY(job, check(options));
  return run_compare(job);
}

constexpr char kCompareFooter[] =
    "Writes into the folder: index.html, a page that needs no network and no other file, with\n"
    "pictures to swap, zoom and expose, error maps, times and settings; results.json and\n"
    "results.csv, the same numbers for programs. The table on stdout is a part of them.\n"
    "\n"
    "--techniques takes entries NAME:KEY=VALUE:KEY=VALUE, separated by commas; none is direct\n"
    "light only, and preset=NAME comes before settings that change it. They are timed in turn, as\n"
    "by `lueur bench`.\n"
    "\n"
    "--reference takes entries MODE:KEY=VALUE, separated by commas, of the modes of\n"
    "`lueur reference`; keys are spp, bounces, error, distance and form-factor. '' compares\n"
    "without the truth. A reference's picture is the renderer's direct light and albedo with the\n"
    "reference's indirect light, so that pictures differ by that alone. Against ambient stands a\n"
    "technique's occlusion, 1 for none; a technique that gives none has no row there.\n"
    "\n"
    "The errors rmse, rel_mse, psnr, ssim, flip, bias and rmse_scaled are those of `lueur diff`\n"
    "on the composed pictures, indirect_... those of indirect light, E/pi before albedo, and\n"
    "occlusion_... those of occlusion, 1 open and 0 closed. Pixels that show no surface do not "
    "count. Times are of this device and machine.\n"
    "\n"
    "Examples:\n"
    "  lueur compare cornell -o out/cornell\n"
    "  lueur compare atrium --techniques hierarchical,hierarchical:start=full,none \\\n"
    "      --reference path,screen -o out/atrium\n"
    "  lueur compare room.glb --reference path:bounces=4:error=0.02:spp=4096 -o out/room\n"
    "  lueur compare atrium --techniques hbao --reference ambient:distance=0.5 -o out/ao\n";

}  // namespace

void add_compare(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("compare", "Hold techniques against the truth");
  auto options = std::make_shared<CompareOptions>();
  add_scene_argument(*command, options->scene);
  add_limit_option(*command, options->limits);
  command->add_option("-o,--output", options->folder, "Folder, made if it is missing")
      ->type_name("FOLDER")
      ->required();
  command
      ->add_option("--techniques", options->techniques,
                   "What to compare (default hierarchical,none)")
      ->type_name("LIST");
  command->add_option("--reference", options->references, "With what (default path)")
      ->type_name("LIST");
  add_frame_options(*command, options->frame);
  command->add_option("--spp", options->spp, "Samples of the references (default 256)")
      ->type_name("N");
  command->add_option("--bounces", options->bounces, "Bounces of path and screen (default 1)")
      ->type_name("N");
  command->add_option("--frames", options->frames, "Frames to time (default 10)")->type_name("N");
  command->add_flag("--no-cache", options->no_cache, "Neither use nor fill the references' cache");
  command->add_flag("--json", options->json, "results.json on stdout instead of the table");
  command->footer(std::string(kCompareFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
