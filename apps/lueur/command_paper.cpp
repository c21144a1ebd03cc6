// SPDX-License-Identifier: MIT
// lueur paper: a paper's figures, made again.
#include <CLI/CLI.hpp>
#include <memory>

#include "arguments.h"
#include "base/try.h"
#include "destination.h"
#include "paper.h"
#include "reference_list.h"

namespace lueur::cli {
namespace {

struct PaperOptions {
  std::string name;
  std::string figures;
  std::string folder;
  std::string size = "1280x720";
  std::string picture_size = "1280x720";
  std::string spp = "256";
  std::string frames = "11";
  std::string seed = "0";
  std::string device;
  bool no_cache = false;
  bool json = false;
};

// The figures of "4,6" in the paper's order; all of them for "".
Result<std::vector<const PaperFigure*>> find_figures(const Paper& paper, const std::string& list) {
  std::vector<std::string> wanted, known;
  if (!list.empty()) wanted = split(list, ',');
  std::vector<const PaperFigure*> found;
  for (const PaperFigure& figure : paper.figures) {
    known.emplace_back(figure.number);
    if (list.empty() || std::erase(wanted, figure.number) > 0) found.push_back(&figure);
  }
  if (!wanted.empty())
    return Error{ErrorKind::usage, "--figures '" + wanted.front() +
                                       "': " + std::string(paper.name) + " has the figures " +
                                       joined(known)};
  return found;
}

// Everything that decides the result, defaults included, so that it holds for later versions, too.
std::string command_of(const PaperOptions& options) {
  std::string command = "lueur paper " + options.name;
  const auto add = [&](const char* flag, const std::string& value) {
    if (!value.empty()) command += std::string(" ") + flag + " " + shell_quoted(value);
  };
  add("--figures", options.figures);
  add("--size", options.size);
  add("--picture-size", options.picture_size);
  add("--spp", options.spp);
  add("--frames", options.frames);
  add("--seed", options.seed);
  add("-o", options.folder);
  return command;
}

Result<PaperJob> check(const PaperOptions& options) {
  PaperJob job;
  LUEUR_TRY(paper, find_named("paper", options.name, papers()));
  job.paper = paper;
  LUEUR_TRY(figures, find_figures(*paper, options.figures));
  job.figures = figures;
  LUEUR_TRY(table_size, parse_size("--size", options.size));
  job.setup.table_size = table_size;
  LUEUR_TRY(picture_size, parse_size("--picture-size", options.picture_size));
  job.setup.picture_size = picture_size;
  LUEUR_TRY(spp, parse_count("--spp", options.spp, 1, reference::kMaxSpp));
  job.setup.spp = spp;
  LUEUR_TRY(frames, parse_count("--frames", options.frames, 1, 10000));
  job.setup.frames = frames;
  LUEUR_TRY(seed, parse_count("--seed", options.seed, 0, UINT32_MAX));
  job.setup.seed = seed;
  if (options.no_cache) job.setup.cache = reference::Cache::ignore;
  job.device = options.device;
  job.json = options.json;
  job.command = command_of(options);
  if (!options.folder.empty()) {
    job.folder = options.folder;
    LUEUR_TRY_VOID(make_folder(job.folder));
  }
  return job;
}

Outcome run(const PaperOptions& options) {
  LUEUR_TRY(job, check(options));
  return run_paper(job);
}

constexpr char kPaperFooter[] =
    "Prints the tables; with -o also writes index.html, a page with the figures, and\n"
    "figures.json. Times are ratios within each table, taken in turn as by `lueur bench`.\n"
    "References come from the cache where it has them, see `lueur reference`.\n"
    "\n"
    "fdp: figure 2 (point to point beside point to disc, cornell), 3 (where samples lie; a glossy\n"
    "floor without and with importance sampling, dominoes), 6 (as hssil's 4), 7 (without and with\n"
    "visibility, table), 9 (what settings cost, level by level, atrium) and 10 (fewer pixels or\n"
    "fewer samples, atrium).\n"
    "hssil: figure 4 (what each level contributes, spot-floor), 5 (point to point and point to\n"
    "disc form factor beside the truth, with a slice, cornell) and 6 with 7 (what settings and\n"
    "levels cost, atrium).\n"
    "sol: 1 (table 1: what lights cost), 2 (table 2 with figures 4 and 7: low resolution first)\n"
    "and 5 (figures 5 and 6: negative lights), floating-object.\n"
    "\n"
    "Examples:\n"
    "  lueur paper hssil -o out/hssil\n"
    "  lueur paper fdp --figures 2,7 --picture-size 640x360 -o out/fdp\n"
    "  lueur paper hssil --figures 6 --frames 31\n";

}  // namespace

void add_paper(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("paper", "Make a paper's tables and figures again");
  auto options = std::make_shared<PaperOptions>();
  const auto add = [&](const char* flag, std::string& value, const char* help, const char* type) {
    command->add_option(flag, value, help)->type_name(type);
  };
  command->add_option("NAME", options->name, "The paper: fdp, hssil, lcm or sol")
      ->type_name("")
      ->required();
  add("-o,--output", options->folder, "Folder of the page, made if it is missing", "FOLDER");
  add("--figures", options->figures, "Such as 4,6 (default: all)", "N,N...");
  add("--size", options->size, "Of tables of times (default 1280x720)", "WxH");
  add("--picture-size", options->picture_size, "Of pictures (default 1280x720)", "WxH");
  add("--spp", options->spp, "Samples of the references (default 256)", "N");
  add("--frames", options->frames, "Frames to time (default 11)", "N");
  add("--seed", options->seed, "Pattern of samples (default 0)", "N");
  add("--device", options->device, "Number or name, see `lueur devices`", "N|NAME");
  command->add_flag("--no-cache", options->no_cache, "Neither use nor fill the references' cache");
  command->add_flag("--json", options->json, "figures.json on stdout instead");
  command->footer(std::string(kPaperFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
