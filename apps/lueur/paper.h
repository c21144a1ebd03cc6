// SPDX-License-Identifier: MIT
// The tables and figures of a paper, made again: its figures beside ours, as ratios within each
// table, since a graphics card of its day says nothing about today's milliseconds.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "commands.h"
#include "frame_options.h"
#include "reference/rendering_file.h"
#include "report/figure_page.h"
#include "session.h"

namespace lueur::cli {

// What all papers are made with.
struct PaperSetup {
  Extent picture_size;  // of figures that show pictures
  Extent table_size;    // of tables of times
  uint32_t spp = 0;     // of references
  uint32_t frames = 0;  // timed, of each row
  uint32_t seed = 0;
  reference::Cache cache = reference::Cache::use;
  std::stop_token stop;
};

struct PaperFigure {
  std::string_view number;  // in the paper
  std::string_view title;
  // What it returns counts for nothing once `setup.stop` asks for an early end.
  Result<report::FigureSection> (*make)(Session& session, const PaperSetup& setup);
};

struct Paper {
  std::string_view name;  // as on the command line
  std::string_view title;
  std::span<const PaperFigure> figures;
};
std::span<const Paper> papers();

// What each level contributes: HSSIL's figure 4 and FDP's figure 6.
Result<report::FigureSection> level_shares(Session& session, const PaperSetup& setup);

// HSSIL: Soler, Hoel, Rochet, Holzschuch, INRIA RR-7162, 2009.
namespace hssil {
// Figure 5: equation (3) beside equation (4) beside the truth, with a slice through each.
Result<report::FigureSection> form_factors(Session& session, const PaperSetup& setup);
// Figures 6 and 7: what settings and levels cost.
Result<report::FigureSection> costs(Session& session, const PaperSetup& setup);
}  // namespace hssil

// FDP: Soler, Hoel, Rochet.
namespace fdp {
// Figure 2: equation (3) beside equation (4).
Result<report::FigureSection> form_factors(Session& session, const PaperSetup& setup);
// Figure 3: where samples lie, and a glossy floor without and with importance sampling.
Result<report::FigureSection> glossy(Session& session, const PaperSetup& setup);
// Figure 7: without and with visibility, and what that takes away.
Result<report::FigureSection> visibility(Session& session, const PaperSetup& setup);
// Figure 9: what settings cost, level by level.
Result<report::FigureSection> costs(Session& session, const PaperSetup& setup);
// Figure 10: fewer pixels or fewer samples.
Result<report::FigureSection> starts(Session& session, const PaperSetup& setup);
}  // namespace fdp

// SOL: Cochran, Steele, ACMSE 2007.
namespace sol {
// Table 1: what lights cost, and what they are off by.
Result<report::FigureSection> light_costs(Session& session, const PaperSetup& setup);
// Table 2 and figures 4 and 7: what is gained, and lost, by a low resolution.
Result<report::FigureSection> low_resolution(Session& session, const PaperSetup& setup);
// Figures 5 and 6: direct, indirect and negative light, without and with negative lights.
Result<report::FigureSection> negative_lights(Session& session, const PaperSetup& setup);
}  // namespace sol

namespace lcm {
Result<report::FigureSection> diffuse(Session& session, const PaperSetup& setup);
Result<report::FigureSection> glossy(Session& session, const PaperSetup& setup);
Result<report::FigureSection> costs(Session& session, const PaperSetup& setup);
}  // namespace lcm

// `lueur paper`: which figures of which paper, and where to.
struct PaperJob {
  const Paper* paper = nullptr;
  std::vector<const PaperFigure*> figures;
  PaperSetup setup;
  std::string device;
  std::filesystem::path folder;  // of the page; empty: none
  std::string command;
  bool json = false;
};
// Makes the figures, writes the page, prints the tables. kExitInterrupted, and nothing written,
// after SIGINT or SIGTERM, which count between figures and while a reference is traced.
Outcome run_paper(PaperJob& job);

}  // namespace lueur::cli
