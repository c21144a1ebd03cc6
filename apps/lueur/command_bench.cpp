// SPDX-License-Identifier: MIT
// lueur bench: what the passes cost, what techniques cost beside each other, and how the cost
// grows.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "arguments.h"
#include "base/try.h"
#include "bench_report.h"
#include "commands.h"
#include "console.h"
#include "limit_option.h"

namespace lueur::cli {
namespace {

struct BenchOptions {
  std::string scene = "atrium";
  LoadLimits limits;
  TechniqueOptions technique;
  std::optional<std::string> techniques;
  FrameOptions frame;
  std::string frames = "10";
  std::optional<std::string> scale;
  std::optional<std::string> triangles;
  bool json = false;
};

// What is to be timed, all of it checked.
struct BenchPlan {
  FrameSetup setup;
  uint32_t frames = 0;
  std::optional<Scale> scale;
  std::vector<std::string> techniques;     // labels
  std::vector<CandidateRequest> requests;  // for each technique, each value of the scale
};

Result<std::vector<ChosenTechnique>> chosen_techniques(const BenchOptions& options) {
  if (options.techniques) return choose_techniques("--techniques", *options.techniques);
  LUEUR_TRY(technique, check(options.technique));
  std::vector<ChosenTechnique> one;
  one.push_back(std::move(technique));
  return one;
}

Result<BenchPlan> check(const BenchOptions& options) {
  BenchPlan plan;
  LUEUR_TRY(setup, check(options.frame));
  plan.setup = setup;
  LUEUR_TRY(frames, parse_count("--frames", options.frames, 1, 10000));
  plan.frames = frames;
  if (options.triangles) {
    LUEUR_TRY(scale, parse_scale("--triangles", "triangles=" + *options.triangles, setup.size));
    plan.scale = scale;
  } else if (options.scale) {
    LUEUR_TRY(scale, parse_scale("--scale", *options.scale, setup.size));
    plan.scale = scale;
  }
  LUEUR_TRY(techniques, chosen_techniques(options));
  for (ChosenTechnique& technique : techniques) {
    plan.techniques.push_back(technique.label);
    CandidateRequest base{technique.label,      options.scene,     setup.size,
                          std::move(technique), setup.environment, options.limits};
    if (!plan.scale) {
      plan.requests.push_back(std::move(base));
      continue;
    }
    for (const std::string& value : plan.scale->values) {
      LUEUR_TRY(request, at_value(*plan.scale, value, base));
      plan.requests.push_back(std::move(request));
    }
  }
  return plan;
}

Outcome run(const BenchOptions& options) {
  LUEUR_TRY(plan, check(options));
  LUEUR_TRY(session, open_session({.device = options.frame.device}));
  BenchReport report;
  report.device = session.system->device();
  report.setup = plan.setup;
  report.frames = plan.frames;
  LUEUR_TRY(candidates, make_candidates(session, std::move(plan.requests), options.frame.camera,
                                        plan.setup.seed, options.frame.side_cameras));
  report.candidates = std::move(candidates);
  print_progress("timing on " + report.device.name);
  LUEUR_TRY(rounds, time_in_turn(session, report.candidates, plan.frames));
  report.summaries = summarize(rounds, report.candidates);
  report.memory = session.context.memory();
  if (plan.scale)
    report.series = fit_series(*plan.scale, plan.techniques, report.candidates, rounds);
  report.scale = std::move(plan.scale);
  LUEUR_TRY_VOID(options.json ? print_json(bench_json(report)) : print_data(bench_text(report)));
  return kExitDone;
}

constexpr char kBenchFooter[] =
    "Renders 3 frames to warm up, or N if that is less, and then N, and reports medians, with\n"
    "the least and the quartiles, as machines are noisy. Every frame is the same one. Several\n"
    "techniques or values are timed in turn, frame by frame, and each ratio is the median of\n"
    "those to the first one in the same turn.\n"
    "\n"
    "gpu ms is the device's own time of a pass. The frame's wall time and the CPU time of the\n"
    "whole process are taken around recording, submitting and waiting; the cpu ms of a pass are\n"
    "its gpu ms * cpu / wall of the frame, which on a CPU device is the work that it did. For the\n"
    "gather passes of hierarchical, cpu ns/sample divides that by the samples taken. The\n"
    "technique's time is that of its passes and its voxels; what the renderer draws for it alone,\n"
    "other views, stands beside it as the host's. These and the frame's are of a second frame, in\n"
    "which passes that belong together share a timer, as timers take time, too: the passes add up\n"
    "to more. The memory of a technique is what a frame needs\n"
    "with it and not without it.\n"
    "\n"
    "--techniques takes entries NAME:KEY=VALUE:KEY=VALUE, separated by commas, none being direct\n"
    "light only; preset=NAME comes before settings that change it. --scale takes pixels (values "
    "WxH), triangles (of atrium) or a setting that is a\n"
    "number, with values or, for pixels, triangles, samples and levels, without. It fits\n"
    "time ~ value^exponent to the technique and to each group of passes, and time = a + b * "
    "value.\n"
    "\n"
    "Examples:\n"
    "  lueur bench\n"
    "  lueur bench --scene cornell --size 1920x1080 --set samples=32 --json\n"
    "  lueur bench --techniques hierarchical,hierarchical:samples=32:start=full,none\n"
    "  lueur bench --scale pixels --frames 20\n"
    "  lueur bench --scale samples=8,16,32,64,128,256 --size 640x360\n"
    "  lueur bench --triangles 10000,100000,1000000\n";

}  // namespace

void add_bench(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("bench", "Time the passes of a frame");
  auto options = std::make_shared<BenchOptions>();
  command->add_option("--scene", options->scene, "A scene, see `lueur render` (default atrium)")
      ->type_name("SCENE");
  add_object_option(*command, options->scene);
  add_limit_option(*command, options->limits);
  add_technique_options(*command, options->technique);
  command->add_option("--techniques", options->techniques, "Several techniques, timed in turn")
      ->type_name("LIST")
      ->excludes("--technique")
      ->excludes("--preset")
      ->excludes("--set");
  add_frame_options(*command, options->frame);
  command->add_option("--frames", options->frames, "Frames to time (default 10)")->type_name("N");
  auto* scale = command->add_option("--scale", options->scale, "How the time grows with something")
                    ->type_name("OF[=V,V...]");
  command->add_option("--triangles", options->triangles, "The same as --scale triangles=N,N...")
      ->type_name("N,N...")
      ->excludes(scale);
  command->add_flag("--json", options->json, "One JSON object on stdout");
  command->footer(std::string(kBenchFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
