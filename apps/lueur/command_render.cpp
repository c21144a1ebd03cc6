// SPDX-License-Identifier: MIT
// lueur render: one picture of a scene, and what is known about how it was made.
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "arguments.h"
#include "base/try.h"
#include "commands.h"
#include "console.h"
#include "frame_options.h"
#include "limit_option.h"
#include "render_job.h"

namespace lueur::cli {
namespace {

// What was typed, before it is checked.
struct RenderOptions {
  std::string scene;
  LoadLimits limits;
  std::vector<std::string> outputs;
  TechniqueOptions technique;
  FrameOptions frame;
  std::string exposure;
  std::string time_s = "0";
  std::string frames;
  std::string fps = "60";
  std::string settle = "0";
  std::string tone_map = "khronos-neutral";
  std::string view;
  std::vector<std::string> dump;
  std::string dump_to;
  bool json = false;
  bool list_views = false;
  bool scan = false;
  bool validate = false;
};

// When the picture is, or the frames are, and where they go.
Result<void> check_frames(const RenderOptions& options, RenderJob& job) {
  LUEUR_TRY(time_s, parse_real("--time", options.time_s, 1e6f));
  LUEUR_TRY(rate, parse_rate("--fps", options.fps));
  job.pace = {.from_s = time_s, .rate = rate};
  if (options.frames.empty()) {
    LUEUR_TRY_VOID(check_no_frames(options.outputs));
    LUEUR_TRY(destinations, check_destinations(options.outputs, job.setup.size));
    job.destinations = destinations;
    return {};
  }
  LUEUR_TRY(frames, parse_frames(options.frames));
  LUEUR_TRY(settle, parse_count("--settle", options.settle, 0, 1000));
  job.frames = frames;
  job.settle = settle;
  const float last_s = time_of(job.pace, static_cast<int32_t>(frames.last));
  if (std::abs(time_s) > kMostSeconds || last_s > kMostSeconds)
    return Error{ErrorKind::usage, "--frames '" + options.frames +
                                       "': beyond the animation's first " +
                                       std::to_string(static_cast<int>(kMostSeconds)) +
                                       " seconds; choose a lower --time or frame"};
  LUEUR_TRY(outputs, check_frame_outputs(options.outputs, frames, job.setup.size));
  job.frame_outputs = std::move(outputs);
  return {};
}

Result<RenderJob> check(const RenderOptions& options) {
  RenderJob job;
  job.scene = options.scene;
  job.limits = options.limits;
  job.camera = options.frame.camera;
  job.side_cameras = options.frame.side_cameras;
  job.view = options.view;
  job.dump = options.dump;
  job.dump_to = options.dump_to;
  job.device = options.frame.device;
  job.json = options.json;
  job.list_views = options.list_views;
  job.scan = options.scan;
  job.validate = options.validate;
  const bool has_result = !options.outputs.empty() || !options.dump.empty() || options.json ||
                          options.list_views || options.scan || options.validate;
  if (!has_result)
    return Error{ErrorKind::usage, "render: nothing to do; name a picture with -o FILE.png"};
  if (!options.view.empty() && options.outputs.empty())
    return Error{ErrorKind::usage, "--view " + options.view + " needs a file; add -o FILE.png"};
  LUEUR_TRY(setup, check(options.frame));
  job.setup = setup;
  LUEUR_TRY(tone_map, parse_tone_map(options.tone_map));
  job.tone_map = tone_map;
  job.tone_map_name = options.tone_map;
  LUEUR_TRY(exposure, parse_exposure(options.exposure));
  job.exposure = exposure;
  LUEUR_TRY(technique, check(options.technique));
  job.technique = std::move(technique);
  LUEUR_TRY_VOID(check_frames(options, job));
  if (!job.dump_to.empty()) LUEUR_TRY_VOID(make_folder(job.dump_to));
  return job;
}

Outcome run(const RenderOptions& options) {
  LUEUR_TRY(job, check(options));
  return run_render(job);
}

constexpr char kRenderFooter[] =
    "SCENE is the name of a built-in scene (lueur scene list), with parameters as in\n"
    "atrium:triangles=250000, or a scene file: a path that ends in .gltf, .glb or .obj, or "
    "exists.\n"
    "--object FILE puts a mesh in the place of the detailed object of divider-room or\n"
    "floating-object, scaled to fit its box.\n"
    "\n"
    "PNG holds the picture as a display shows it. EXR holds scene-referred light, the main\n"
    "picture and a layer each for direct, indirect, what the technique tells beside it (lueur\n"
    "techniques names it), albedo, normal (world space), depth (metres along the view axis, 0:\n"
    "nothing), specular, emission, source, motion and material; its header says how it was made.\n"
    "\n"
    "Without --exposure the scene's own exposure holds, or a light meter's if it has none. The\n"
    "default tone map, khronos-neutral, shows what is below 80 % of white as it is, so that two\n"
    "pictures differ by their light and not by the curve; only highlights are compressed.\n"
    "\n"
    "With --json the frame is rendered twice and the second one is reported: the first one pays\n"
    "for compiling pipelines and touching memory. technique_ms is the sum of the passes of the\n"
    "technique, voxels included, host_ms of the other views that the renderer draws for it,\n"
    "frame_ms of all passes, all of it GPU time.\n"
    "\n"
    "--frames A-B renders frames of the animation one after the other, as an application would:\n"
    "frame N shows the second --time + N / --fps, its seed is --seed + N, and what a technique\n"
    "remembers stays with it. -o then names pictures by their frame, {frame} or with leading "
    "zeros\n"
    "{frame:4}, or a video, .mp4, .webm or .mkv, which the program ffmpeg has to be there for. "
    "What\n"
    "the first frame is exposed by, --exposure auto or another, holds for all. Ctrl-C stops "
    "between\n"
    "two frames. --json tells medians of all frames.\n"
    "\n"
    "Examples:\n"
    "  lueur render cornell -o cornell.png\n"
    "  lueur render divider-room --object figure.glb -o figure.png\n"
    "  lueur render room.glb --technique none --exposure auto -o direct.png -o direct.exr\n"
    "  lueur render atrium --set samples=32 --set start=full --json -o atrium.png\n"
    "  lueur render cornell --list-views\n"
    "  lueur render cornell --view hierarchical.gather@0.indirect -o level0.png\n"
    "  lueur render cornell --dump 'hierarchical.*' --dump-to passes\n"
    "  lueur render room.glb --scan --validate\n"
    "  lueur render cornell --frames 0-119 -o cornell.mp4\n"
    "  lueur render cornell --frames 0-23 --fps 24 --settle 8 -o {frame:4}.png -o {frame:4}.exr\n";

void add_look_options(CLI::App* command, const std::shared_ptr<RenderOptions>& options) {
  command->add_option("--time", options->time_s, "Seconds into the animation (default 0)")
      ->type_name("SECONDS");
  auto* frames =
      command->add_option("--frames", options->frames, "Render these frames of the animation")
          ->type_name("A-B");
  command->add_option("--fps", options->fps, "Frames a second (default 60)")->type_name("FPS");
  command->add_option("--settle", options->settle, "Frames before those, not written (default 0)")
      ->type_name("N")
      ->needs(frames);
  command
      ->add_option("--exposure", options->exposure,
                   "Stops to add, or auto: by the picture, with --frames by the first")
      ->type_name("EV|auto");
  std::vector<std::string> curves;
  curves.reserve(kToneMapNames.size());
  for (const ToneMapName& row : kToneMapNames) curves.emplace_back(row.name);
  command
      ->add_option("--tone-map", options->tone_map, joined(curves) + " (default khronos-neutral)")
      ->type_name("CURVE");
}

void add_inspection_options(CLI::App* command, const std::shared_ptr<RenderOptions>& options) {
  command->add_flag("--json", options->json, "Report as one JSON object on stdout");
  auto* list_views =
      command->add_flag("--list-views", options->list_views, "List the images that --view takes");
  auto* view =
      command->add_option("--view", options->view, "Write PASS.IMAGE instead of the picture")
          ->type_name("PASS.IMAGE");
  auto* dump = command
                   ->add_option("--dump", options->dump,
                                "Write images PASS.IMAGE, * being anything, as EXR files")
                   ->type_name("PATTERN");
  dump->allow_extra_args(false);
  auto* dump_to =
      command->add_option("--dump-to", options->dump_to, "Folder of --dump")->type_name("FOLDER");
  dump->needs(dump_to);
  dump_to->needs(dump);
  view->excludes(dump);
  // These are of one frame.
  command->get_option("--frames")->excludes(dump)->excludes(list_views);
  command->add_flag("--scan", options->scan,
                    "Search all passes for NaN, infinite and negative light");
  command->add_flag("--validate", options->validate, "Let Vulkan's validation layer watch");
}

}  // namespace

void add_render(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("render", "Render one picture of a scene");
  auto options = std::make_shared<RenderOptions>();
  add_scene_argument(*command, options->scene);
  add_limit_option(*command, options->limits);
  command
      ->add_option("-o,--output", options->outputs,
                   "Picture, .png or .exr, or video; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_technique_options(*command, options->technique);
  add_frame_options(*command, options->frame);
  add_look_options(command, options);
  add_inspection_options(command, options);
  command->footer(std::string(kRenderFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
