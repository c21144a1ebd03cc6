// SPDX-License-Identifier: MIT
// SOL's table 1: what lights cost, and then what they are off by.
#include <string>

#include "base/try.h"
#include "paper_sol_parts.h"

namespace lueur::cli::sol {
namespace {

struct CostRow {
  uint32_t positive, negative;
  double frames_a_second;
};
constexpr CostRow kCosts[] = {{100, 50, 26.5}, {150, 0, 32.6},   {200, 100, 15.6},
                              {300, 0, 19.2},  {300, 150, 11.0}, {450, 0, 13.6}};

}  // namespace

Result<report::FigureSection> light_costs(Session& session, const PaperSetup& setup) {
  std::vector<LightSettings> settings;
  for (const CostRow& row : kCosts) settings.push_back(lights(row.positive, row.negative));
  LUEUR_TRY(candidates, light_candidates(session, setup, kScene, setup.table_size, settings));
  LUEUR_TRY(rounds, time_in_turn(session, candidates, setup.frames));
  report::Table table{"Time, the first row being 1", {}, {}};
  table.columns = {
      {"lights, negative lights", "", "", 3}, {"paper", "", "", 3}, {"ours", "", "", 3}};
  for (size_t i = 0; i < std::size(kCosts); ++i)
    table.rows.push_back(
        {std::to_string(kCosts[i].positive) + ", " + std::to_string(kCosts[i].negative),
         kCosts[0].frames_a_second / kCosts[i].frames_a_second,
         technique_ratio(rounds, candidates, i, 0)});
  report::FigureSection section;
  section.blocks = {
      report::Paragraph{place_and_rounds(setup)}, table,
      report::Paragraph{
          "The paper's time is that of a whole frame, ours that of the technique's passes. In the "
          "paper negative lights cost more than others, as they are found for all pixels; here "
          "they are found for those that become lights, and cost as much as others."}};
  LUEUR_TRY(errors, errors_by_lights(session, setup));
  section.blocks.insert(section.blocks.end(), errors.begin(), errors.end());
  return section;
}

}  // namespace lueur::cli::sol
