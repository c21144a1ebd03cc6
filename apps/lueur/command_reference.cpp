// SPDX-License-Identifier: MIT
// lueur reference: the truth that techniques are held against.
#include <CLI/CLI.hpp>
#include <memory>

#include "arguments.h"
#include "base/try.h"
#include "commands.h"
#include "frame_options.h"
#include "limit_option.h"
#include "reference_job.h"
#include "reference_list.h"

namespace lueur::cli {
namespace {

struct ReferenceOptions {
  std::string scene;
  LoadLimits limits;
  std::vector<std::string> outputs;
  std::string mode = "path";
  std::string bounces = "1";
  std::string spp = "256";
  std::string error;
  FrameOptions frame;
  std::string time_s = "0";
  std::string distance_m = "1";
  std::string form_factor = "disc";
  std::string threads = "0";
  std::string exposure;
  std::string tone_map = "khronos-neutral";
  bool resume = false;
  bool no_cache = false;
  bool json = false;
};

Result<reference::Settings> parse_settings(const ReferenceOptions& options) {
  reference::Settings settings;
  LUEUR_TRY(mode, parse_mode("--mode", options.mode));
  settings.mode = mode;
  const std::pair<const char*, const std::string*> given[] = {
      {"bounces", &options.bounces},
      {"spp", &options.spp},
      {"error", &options.error},
      {"distance", &options.distance_m},
      {"form-factor", &options.form_factor}};
  for (const auto& [key, value] : given)
    if (!value->empty()) LUEUR_TRY_VOID(set_reference(settings, "--", key, *value));
  return settings;
}

Result<ReferenceJob> check(const ReferenceOptions& options) {
  ReferenceJob job;
  job.scene = options.scene;
  job.limits = options.limits;
  job.camera = options.frame.camera;
  job.resume = options.resume;
  if (options.no_cache) job.cache = reference::Cache::ignore;
  job.json = options.json;
  if (options.outputs.empty())
    return Error{ErrorKind::usage, "reference: nowhere to write; name a file with -o FILE.exr"};
  LUEUR_TRY(frame, check(options.frame));
  job.shot.width = frame.size.width;
  job.shot.height = frame.size.height;
  LUEUR_TRY(time_s, parse_real("--time", options.time_s, 1e6f));
  job.shot.time_s = time_s;
  LUEUR_TRY(settings, parse_settings(options));
  job.settings = settings;
  job.settings.seed = frame.seed;
  job.environment = frame.environment;
  LUEUR_TRY(threads, parse_count("--threads", options.threads, 0, 1024));
  job.threads = threads;
  LUEUR_TRY(tone_map, parse_tone_map(options.tone_map));
  job.tone_map = tone_map;
  LUEUR_TRY(exposure, parse_exposure(options.exposure));
  job.exposure = exposure;
  LUEUR_TRY(destinations, check_destinations(options.outputs, frame.size));
  job.destinations = destinations;
  return job;
}

Outcome run(const ReferenceOptions& options) {
  LUEUR_TRY(job, check(options));
  return run_reference(job);
}

constexpr char kReferenceFooter[] =
    "Rays go through the centres of the pixels, as the rasterizer's do. Modes:\n"
    "  path               path tracing: all light that came off 1 to --bounces surfaces\n"
    "  screen             the same, and only diffuse, off surfaces that the camera sees\n"
    "  screen-unoccluded  the sum over all pixels without visibility, HSSIL (4) or (3); --spp is\n"
    "                     how many pixels are summed, 0 is all of them\n"
    "  lights             the sum over patches that --spp rays of the lights shine on, by shadow\n"
    "                     rays, SOL 3.2 with 3.3's I_c\n"
    "  lights-unoccluded  the same through everything, I_s\n"
    "  ambient            ambient occlusion within --distance metres\n"
    "\n"
    "EXR holds 32-bit floats: the picture, direct, indirect (E/pi before albedo),\n"
    "indirect_specular, variance (of the mean of indirect), albedo, normal, depth, specular,\n"
    "emission and source; of ambient, occlusion. The layers are those of `lueur render`.\n"
    "\n"
    "The same seed gives the same bits for any number of threads. The estimated relative error\n"
    "is the root of the mean variance over the mean; --error ends the work when it is reached.\n"
    "Ctrl-C writes what there is, and beside the first file FILE.resume, which is also kept up\n"
    "to date every minute; --resume goes on from there, also to more --spp than at first, to the\n"
    "bits that it would have had. What is finished is kept in the cache folder (XDG_CACHE_HOME,\n"
    "else ~/.cache) under lueur/references, by the content of scene, shot and settings; it may\n"
    "be deleted at any time.\n"
    "\n"
    "Examples:\n"
    "  lueur reference cornell -o truth.exr --mode path --bounces 1 --spp 256\n"
    "  lueur reference atrium -o truth.exr -o truth.png --error 0.01 --spp 4096\n"
    "  lueur reference room.glb -o ao.png --mode ambient --distance 0.5\n";

void add_options(CLI::App* command, const std::shared_ptr<ReferenceOptions>& options) {
  const auto add = [&](const char* flag, std::string& value, const char* help, const char* type) {
    return command->add_option(flag, value, help)->type_name(type);
  };
  add_view_options(*command, options->frame);
  add("--mode", options->mode, "What is computed, see below (default path)", "MODE");
  add("--bounces", options->bounces, "Surfaces between light and receiver (default 1)", "N");
  add("--spp", options->spp, "Samples a pixel (default 256)", "N");
  add("--error", options->error, "Stop at this estimated relative error", "SHARE");
  add("--time", options->time_s, "Seconds into the animation (default 0)", "SECONDS");
  add("--distance", options->distance_m, "Reach of ambient, in metres (default 1)", "M");
  add("--form-factor", options->form_factor, "Of the sums: disc or point", "KIND");
  add("--threads", options->threads, "0: as many as the machine has (default)", "N");
  add("--exposure", options->exposure, "Of a PNG: stops to add, or auto", "EV|auto");
  add("--tone-map", options->tone_map, "Of a PNG, see `lueur render`", "CURVE");
  command->add_flag("--resume", options->resume, "Go on from FILE.resume");
  command->add_flag("--no-cache", options->no_cache, "Neither use nor fill the cache");
  command->add_flag("--json", options->json, "Report as one JSON object on stdout");
}

}  // namespace

void add_reference(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("reference", "Trace the true indirect light");
  auto options = std::make_shared<ReferenceOptions>();
  add_scene_argument(*command, options->scene);
  add_limit_option(*command, options->limits);
  command->add_option("-o,--output", options->outputs, "Picture, .exr or .png; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_options(command, options);
  command->footer(std::string(kReferenceFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
