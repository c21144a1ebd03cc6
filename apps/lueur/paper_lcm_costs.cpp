// SPDX-License-Identifier: MIT
// What the texels of localized cube maps cost.
#include <string>

#include "base/try.h"
#include "paper_parts.h"

namespace lueur::cli::lcm {

Result<report::FigureSection> costs(Session& session, const PaperSetup& setup) {
  // With a scene probe, so that all pixels gather.
  const char* const kSides[] = {"2", "4", "8"};
  std::vector<CandidateRequest> requests;
  for (const char* side : kSides) {
    LUEUR_TRY(request, paper_request("cube_map", "divider-room", setup.table_size,
                                     {std::string("side=") + side, "probes=1"}));
    requests.push_back(std::move(request));
  }
  LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
  LUEUR_TRY(rounds, time_in_turn(session, candidates, setup.frames));
  report::Table table{"Time, M = 2 being 1", {}, {}};
  table.columns = {{"M", "", "", 3}, {"texels", "", "", 3}, {"time", "", "", 3}};
  for (size_t i = 0; i < std::size(kSides); ++i) {
    const double side = std::stod(kSides[i]);
    table.rows.push_back({kSides[i], 6.0 * side * side, technique_ratio(rounds, candidates, i, 0)});
  }
  report::FigureSection section;
  section.blocks = {
      table, report::Paragraph{
                 "divider-room at " + std::to_string(setup.table_size.width) + " x " +
                 std::to_string(setup.table_size.height) + ", medians of ratios within each of " +
                 std::to_string(setup.frames) + " rounds; nothing is captured, as nothing moves."}};
  return section;
}

}  // namespace lueur::cli::lcm
