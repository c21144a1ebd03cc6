// SPDX-License-Identifier: MIT
// lueur bench: what the passes cost, and how a technique's cost depends on the scene.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "arguments.h"
#include "base/try.h"
#include "bench_run.h"
#include "commands.h"
#include "console.h"
#include "json_output.h"

namespace lueur::cli {
namespace {

struct Options {
  std::string scene = "atrium";
  std::string technique = "hierarchical";
  std::vector<std::string> settings;
  std::string size = "1280x720";
  std::string camera;
  std::string frames = "10";
  std::string seed = "0";
  std::string device;
  std::vector<std::string> triangles;
  bool json = false;
};

struct Plan {
  std::vector<std::string> scenes;
  Extent size;
  uint32_t frames = 0;
  uint32_t seed = 0;
};

Result<Plan> check(const Options& options) {
  Plan plan;
  LUEUR_TRY(size, parse_size(options.size));
  plan.size = size;
  LUEUR_TRY(frames, parse_count("--frames", options.frames, 1, 10000));
  plan.frames = frames;
  LUEUR_TRY(seed, parse_count("--seed", options.seed, 0, UINT32_MAX));
  plan.seed = seed;
  if (options.triangles.empty()) {
    plan.scenes.push_back(options.scene);
    return plan;
  }
  if (options.scene != "atrium")
    return Error{ErrorKind::usage, "--triangles goes with --scene atrium, not with '" +
                                       options.scene + "'; leave one of them out"};
  for (const std::string& text : options.triangles) {
    LUEUR_TRY(count, parse_count("--triangles", text, 1, UINT32_MAX));
    plan.scenes.push_back("atrium:triangles=" + std::to_string(count));
  }
  return plan;
}

Result<Candidate> make_candidate(const Options& options, const Plan& plan, const std::string& name,
                                 Session& session) {
  print_progress("loading " + name);
  LUEUR_TRY(loaded, load_scene(name));
  LUEUR_TRY(camera, find_camera(loaded.scene, options.camera));
  LUEUR_TRY(technique, choose_technique(options.technique, options.settings));
  LUEUR_TRY(renderer, Renderer::create(*session.system, session.context, loaded.scene));
  for (const std::string& warning : loaded.scene.warnings) print_warning(warning);
  for (const std::string& warning : renderer->warnings()) print_warning(warning);
  Candidate candidate;
  candidate.scene_name = name;
  candidate.triangles = triangle_count(loaded.scene);
  candidate.renderer = std::move(renderer);
  candidate.technique = std::move(technique);
  candidate.shot = {.extent = plan.size, .camera = camera, .seed = plan.seed};
  return candidate;
}

// Times the candidates in turn, A B C A B C …, so that what slows the machine down for a while
// slows all of them.
Result<std::vector<BenchSummary>> measure(Session& session, std::vector<Candidate>& candidates,
                                          uint32_t frames) {
  std::vector<std::vector<FrameTimes>> times(candidates.size());
  for (uint32_t frame = 0; frame < kWarmUpFrames + frames; ++frame) {
    for (size_t i = 0; i < candidates.size(); ++i) {
      LUEUR_TRY(taken, time_frame(session, candidates[i]));
      if (frame >= kWarmUpFrames) times[i].push_back(std::move(taken));
    }
  }
  std::vector<BenchSummary> summaries;
  for (size_t i = 0; i < candidates.size(); ++i)
    summaries.push_back(summarize(times[i], candidates[i]));
  return summaries;
}

double max_over_min(const std::vector<BenchSummary>& summaries) {
  const auto by_technique = [](const BenchSummary& a, const BenchSummary& b) {
    return a.technique_ms < b.technique_ms;
  };
  const auto [least, most] = std::minmax_element(summaries.begin(), summaries.end(), by_technique);
  return least->technique_ms > 0 ? most->technique_ms / least->technique_ms : 1.0;
}

Json run_json(const Candidate& candidate, const BenchSummary& summary) {
  Json passes = Json::array();
  for (const PassSummary& row : summary.passes) {
    Json pass = {
        {"name", row.name}, {"gpu_ms", rounded_ms(row.gpu_ms)}, {"cpu_ms", rounded_ms(row.cpu_ms)}};
    if (row.samples) {
      pass["samples"] = *row.samples;
      pass["cpu_ns_per_sample"] = row.cpu_ms * 1e6 / static_cast<double>(*row.samples);
    }
    passes.push_back(std::move(pass));
  }
  return {{"scene", candidate.scene_name},
          {"triangles", candidate.triangles},
          {"technique_ms", rounded_ms(summary.technique_ms)},
          {"frame_ms", rounded_ms(summary.frame_ms)},
          {"wall_ms", rounded_ms(summary.wall_ms)},
          {"cpu_ms", rounded_ms(summary.cpu_ms)},
          {"passes", std::move(passes)}};
}

Json bench_json(const Plan& plan, const Session& session, const std::vector<Candidate>& candidates,
                const std::vector<BenchSummary>& summaries) {
  const ChosenTechnique& technique = candidates.front().technique;
  const MemoryUse memory = session.context.memory();
  Json json = {{"version", LUEUR_VERSION},
               {"device", device_json(session.system->device())},
               {"size", size_json(plan.size)},
               {"technique", technique.name()},
               {"settings", settings_json(technique.info, technique.technique.get())},
               {"seed", plan.seed},
               {"frames", plan.frames},
               {"warm_up_frames", kWarmUpFrames},
               {"memory_bytes", memory.total_bytes},
               {"peak_memory_bytes", memory.peak_bytes}};
  if (candidates.size() == 1) {
    json.update(run_json(candidates.front(), summaries.front()));
    return json;
  }
  Json runs = Json::array();
  for (size_t i = 0; i < candidates.size(); ++i)
    runs.push_back(run_json(candidates[i], summaries[i]));
  json["runs"] = std::move(runs);
  json["technique_ms_max_over_min"] = max_over_min(summaries);
  return json;
}

// One formatted line of the table.
template <class... Values>
std::string row(const char* format, Values... values) {
  char line[256];
  std::snprintf(line, sizeof(line), format, values...);
  return line;
}

std::string run_text(const Candidate& candidate, const BenchSummary& summary) {
  std::string text = printable(candidate.scene_name) + ", " + std::to_string(candidate.triangles) +
                     " triangles\n" +
                     row("  %-34s %10s %10s %14s\n", "pass", "gpu ms", "cpu ms", "cpu ns/sample");
  for (const PassSummary& pass : summary.passes) {
    text += row("  %-34s %10.3f %10.3f", pass.name.c_str(), pass.gpu_ms, pass.cpu_ms);
    if (pass.samples)
      text += row(" %14.3f", pass.cpu_ms * 1e6 / static_cast<double>(*pass.samples));
    text += "\n";
  }
  text += row("  %-34s %10.3f\n", "technique", summary.technique_ms);
  text += row("  %-34s %10.3f\n", "all passes", summary.frame_ms);
  text +=
      row("  %-34s %10.3f %10.3f\n", "frame, wall and process", summary.wall_ms, summary.cpu_ms);
  return text;
}

std::string bench_text(const Plan& plan, const Session& session,
                       const std::vector<Candidate>& candidates,
                       const std::vector<BenchSummary>& summaries) {
  std::string text = "lueur " LUEUR_VERSION " on " + printable(session.system->device().name) +
                     ", " + std::to_string(plan.size.width) + "x" +
                     std::to_string(plan.size.height) + ", " + candidates.front().technique.name() +
                     ", medians of " + std::to_string(plan.frames) + " frames\n";
  for (size_t i = 0; i < candidates.size(); ++i) text += run_text(candidates[i], summaries[i]);
  if (candidates.size() > 1)
    text += row("technique, most over least: %.3f\n", max_over_min(summaries));
  return text;
}

Outcome run(const Options& options) {
  LUEUR_TRY(plan, check(options));
  // Refuse wrong settings before the device is opened.
  LUEUR_TRY_VOID([&]() -> Result<void> {
    LUEUR_TRY(technique, choose_technique(options.technique, options.settings));
    static_cast<void>(technique);
    return {};
  }());
  LUEUR_TRY(session, open_session({.device = options.device}));
  std::vector<Candidate> candidates;
  for (const std::string& name : plan.scenes) {
    LUEUR_TRY(candidate, make_candidate(options, plan, name, session));
    candidates.push_back(std::move(candidate));
  }
  print_progress("timing on " + session.system->device().name);
  LUEUR_TRY(summaries, measure(session, candidates, plan.frames));
  LUEUR_TRY_VOID(options.json ? print_json(bench_json(plan, session, candidates, summaries))
                              : print_data(bench_text(plan, session, candidates, summaries)));
  return kExitDone;
}

constexpr char kFooter[] =
    "Renders 3 frames to warm up and then N, and reports medians. Every frame is the same one.\n"
    "gpu ms is the device's own time of a pass. The frame's wall time and the CPU time of the\n"
    "whole process are taken around recording, submitting and waiting; the cpu ms of a pass are\n"
    "its gpu ms * cpu / wall of the frame, which on a CPU device is the work that it did. For the\n"
    "gather passes of hierarchical, cpu ns/sample divides that by the samples taken.\n"
    "With --triangles the scenes are timed in turn, frame by frame.\n"
    "\n"
    "Examples:\n"
    "  lueur bench\n"
    "  lueur bench --scene cornell --size 1920x1080 --set samples=32 --json\n"
    "  lueur bench --triangles 10000,100000,1000000 --frames 20\n";

}  // namespace

void add_bench(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("bench", "Time the passes of a frame");
  auto options = std::make_shared<Options>();
  command->add_option("--scene", options->scene, "A scene, see `lueur render` (default atrium)")
      ->type_name("SCENE");
  command->add_option("--size", options->size, "In pixels (default 1280x720)")->type_name("WxH");
  command
      ->add_option("--technique", options->technique,
                   "Of `lueur techniques`, or none (default hierarchical)")
      ->type_name("NAME");
  command->add_option("--set", options->settings, "A setting of the technique; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--camera", options->camera, "A camera's name or number (default: first)")
      ->type_name("NAME|N");
  command->add_option("--frames", options->frames, "Frames to time (default 10)")->type_name("N");
  command->add_option("--seed", options->seed, "Pattern of samples (default 0)")->type_name("N");
  command
      ->add_option("--triangles", options->triangles,
                   "Sizes of atrium to compare, such as 10000,100000")
      ->type_name("N,N...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--device", options->device, "Number or name, see `lueur devices`")
      ->type_name("N|NAME");
  command->add_flag("--json", options->json, "One JSON object on stdout");
  command->footer(std::string(kFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
