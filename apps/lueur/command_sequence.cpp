// SPDX-License-Identifier: MIT
// lueur sequence: frames of an animation, and the errors that only show in motion.
#include <CLI/CLI.hpp>
#include <memory>

#include "arguments.h"
#include "base/try.h"
#include "destination.h"
#include "limit_option.h"
#include "sequence_job.h"

namespace lueur::cli {
namespace {

struct SequenceOptions {
  std::string scene;
  LoadLimits limits;
  std::string techniques = "hierarchical";
  std::string from = "0";
  std::string rate = "60";
  std::string frames = "16";
  std::string settle = "8";
  std::string average = "16";
  std::string uncovered = "8";
  std::string hold;
  FrameOptions frame{.size = "640x360"};
  std::string folder;
  bool fixed_seed = false;
  bool json = false;
};

Result<Hold> parse_hold(const std::string& text) {
  if (text.empty()) return Hold::nothing;
  if (text == "camera") return Hold::camera;
  if (text == "scene") return Hold::scene;
  return Error{ErrorKind::usage, "--hold '" + text + "': expected camera or scene"};
}

Result<Sequence> check_sequence(const SequenceOptions& options) {
  LUEUR_TRY(setup, check(options.frame));
  LUEUR_TRY(from_s, parse_real("--from", options.from, kMostSeconds));
  LUEUR_TRY(rate, parse_rate("--rate", options.rate));
  LUEUR_TRY(frames, parse_count("--frames", options.frames, 2, 10000));
  LUEUR_TRY(settle, parse_count("--settle", options.settle, 0, 1000));
  LUEUR_TRY(average, parse_count("--average", options.average, 1, 10000));
  LUEUR_TRY(uncovered, parse_count("--uncovered", options.uncovered, 1, 10000));
  return Sequence{setup,    Pace{from_s, rate, options.fixed_seed}, frames, settle, average,
                  uncovered};
}

Result<SequenceJob> check(const SequenceOptions& options) {
  SequenceJob job;
  job.scene = options.scene;
  job.limits = options.limits;
  job.frame = options.frame;
  job.json = options.json;
  LUEUR_TRY(sequence, check_sequence(options));
  job.sequence = sequence;
  LUEUR_TRY(hold, parse_hold(options.hold));
  job.hold = hold;
  LUEUR_TRY(techniques, choose_techniques("--techniques", options.techniques));
  job.techniques = std::move(techniques);
  job.folder = options.folder;
  if (!job.folder.empty()) LUEUR_TRY_VOID(make_folder(job.folder));
  return job;
}

Outcome run(const SequenceOptions& options) {
  LUEUR_TRY(job, check(options));
  return run_sequence(job);
}

constexpr char kSequenceFooter[] =
    "Renders N frames one after the other with each technique, as an application would: the seed\n"
    "counts up and what a technique remembers stays with it. All figures are of the luminance of\n"
    "indirect light, E/pi before albedo.\n"
    "\n"
    "flicker is how much a followed point changes from frame to frame, as a share of its light.\n"
    "reference is the same of converged frames: the means of K renderings of each instant "
    "standing\n"
    "still, with the same technique. excess is flicker - reference: noise and unrest, without the\n"
    "light that really moved. ghost bias and error are those against the converged frames, over\n"
    "the pixels that were uncovered during the last --uncovered frames; below 0 is too dark.\n"
    "\n"
    "--settle frames are rendered before the sequence, and at each instant before its mean, and "
    "do\n"
    "not count; a technique without a memory needs none.\n"
    "\n"
    "-o writes the composed frames as LABEL-0000.png and so on, all at one exposure; what file\n"
    "names do not allow in a label becomes _.\n"
    "\n"
    "Examples:\n"
    "  lueur sequence cornell\n"
    "  lueur sequence atrium --techniques hierarchical:samples=16,hierarchical --json\n"
    "  lueur sequence cornell --hold camera --from 2 --rate 30 --frames 30 -o frames\n"
    "  lueur sequence cornell --fixed-seed --settle 0\n";

void add_sequence_options(CLI::App& command, SequenceOptions& options) {
  const auto add = [&](const char* flag, std::string& value, const char* help, const char* type) {
    command.add_option(flag, value, help)->type_name(type);
  };
  add("--techniques", options.techniques, "What to render with (default hierarchical)", "LIST");
  add("--from", options.from, "Seconds into the animation (default 0)", "SECONDS");
  add("--rate", options.rate, "Frames a second (default 60)", "FPS");
  add("--frames", options.frames, "Frames that count, 2 or more (default 16)", "N");
  add("--settle", options.settle, "Frames before those (default 8)", "N");
  add("--average", options.average, "Renderings in a converged frame (default 16)", "K");
  add("--uncovered", options.uncovered, "How long a pixel counts as uncovered (default 8)", "N");
  add("--hold", options.hold, "What stands still: camera, or scene for all else", "WHAT");
  command.add_flag("--fixed-seed", options.fixed_seed, "All frames have the seed of --seed");
}

}  // namespace

void add_sequence(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("sequence", "Measure flicker and ghosts in motion");
  auto options = std::make_shared<SequenceOptions>();
  add_scene_argument(*command, options->scene);
  add_limit_option(*command, options->limits);
  command
      ->add_option("-o,--output", options->folder, "Folder for the frames, made if it is missing")
      ->type_name("FOLDER");
  add_sequence_options(*command, *options);
  add_frame_options(*command, options->frame);
  command->add_flag("--json", options->json, "One JSON object on stdout");
  command->footer(std::string(kSequenceFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
