// SPDX-License-Identifier: MIT
#include "paper.h"

#include "base/try.h"
#include "console.h"
#include "figure_text.h"
#include "interrupt.h"
#include "json_output.h"

namespace lueur::cli {
namespace {

constexpr PaperFigure kHssilFigures[] = {
    {"4", "Figure 4: what each level contributes", level_shares},
    {"5", "Figure 5: point to point, point to disc, and the truth", hssil::form_factors},
    {"6", "Figures 6 and 7: what settings and levels cost", hssil::costs},
};

constexpr PaperFigure kFdpFigures[] = {
    {"2", "Figure 2: point to point and point to disc", fdp::form_factors},
    {"3", "Figure 3: where samples lie, and glossy reflection", fdp::glossy},
    {"6", "Figure 6: what each level contributes", level_shares},
    {"7", "Figure 7: indirect shadows", fdp::visibility},
    {"9", "Figure 9: what settings and levels cost", fdp::costs},
    {"10", "Figure 10: fewer pixels or fewer samples", fdp::starts},
};

constexpr PaperFigure kSolFigures[] = {
    {"1", "Table 1: what lights cost, and gain", sol::light_costs},
    {"2", "Table 2, figures 4 and 7: low resolution first", sol::low_resolution},
    {"5", "Figures 5 and 6: what negative lights take away", sol::negative_lights},
};

constexpr PaperFigure kLcmFigures[] = {
    {"6", "Figure 6: a diffuse object in four places", lcm::diffuse},
    {"7", "Figures 7 and 8: a glossy object in four places", lcm::glossy},
    {"cost", "What texels cost", lcm::costs},
};

constexpr Paper kPapers[] = {
    {"fdp",
     "A Fast Deferred Shading Pipeline for Real Time Approximate Indirect Illumination (Soler, "
     "Hoel, Rochet)",
     kFdpFigures},
    {"hssil",
     "Hierarchical Screen-Space Indirect Illumination for Video Games (INRIA RR-7162, 2009)",
     kHssilFigures},
    {"lcm", "Indirect Diffuse and Glossy Illumination on the GPU (Szirmay-Kalos, Lazányi 2006)",
     kLcmFigures},
    {"sol", "Second-Order Illumination in Real-Time (Cochran, Steele 2007)", kSolFigures},
};

}  // namespace

std::span<const Paper> papers() {
  return kPapers;
}

Outcome run_paper(PaperJob& job) {
  // Before the device, whose threads would take its signals.
  const InterruptWatch watch;
  job.setup.stop = watch.token();
  LUEUR_TRY(session, open_session({.device = job.device}));
  report::FigurePage page;
  page.title = std::string(job.paper->title);
  page.summary =
      "What the paper shows, made again by this program. Times are ratios within each table: the "
      "paper's graphics cards and this device have nothing else in common.";
  page.facts = {{"device", session.system->device().name}, {"version", LUEUR_VERSION}};
  page.command = job.command;
  for (const PaperFigure* figure : job.figures) {
    print_progress("making " + std::string(figure->title));
    LUEUR_TRY(section, figure->make(session, job.setup));
    if (job.setup.stop.stop_requested()) {
      print_warning("interrupted; nothing was written");
      return kExitInterrupted;
    }
    section.title = std::string(figure->title);
    page.sections.push_back(std::move(section));
  }
  if (!job.folder.empty()) LUEUR_TRY_VOID(write_figure_page(page, job.folder));
  if (job.json) {
    LUEUR_TRY(json, report::figures_json(page));
    LUEUR_TRY_VOID(print_json(json));
  } else {
    LUEUR_TRY_VOID(print_data(figure_text(page)));
  }
  return kExitDone;
}

}  // namespace lueur::cli
