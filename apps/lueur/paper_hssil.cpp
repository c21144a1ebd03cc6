// SPDX-License-Identifier: MIT
// HSSIL figures 6 and 7.
#include <string>

#include "base/try.h"
#include "paper_parts.h"

namespace lueur::cli::hssil {
namespace {

struct CostRow {
  const char* start;
  uint32_t levels, samples;
  // Milliseconds on (a) an 8800 GTS and (b) a GTX 260 at 1280 x 720: HSSIL, i.e. the gather,
  // up-sampling, and everything.
  double gather_ms[2], upsampling_ms[2], total_ms[2];
};
constexpr CostRow kCosts[] = {
    {"half", 4, 64, {26.6, 7.8}, {7.1, 2.1}, {34.8, 10.5}},
    {"quarter", 4, 64, {7.1, 2.3}, {5.7, 1.7}, {13.9, 4.6}},
    {"quarter", 4, 256, {26.8, 8.9}, {5.7, 1.7}, {33.6, 11.2}},
    {"half", 4, 256, {102.4, 29.9}, {7.1, 2.1}, {110.6, 32.6}},
    {"half", 5, 64, {26.8, 7.85}, {7.2, 2.1}, {35.1, 10.55}},
};
constexpr size_t kBase = 0, kQuarter = 1, kQuarterMany = 2, kHalfMany = 3, kFiveLevels = 4;

std::string name_of(const CostRow& row) {
  return std::string(row.start) + ", " + std::to_string(row.levels) + " levels, " +
         std::to_string(row.samples) + " samples";
}

Result<std::vector<Candidate>> cost_candidates(Session& session, const PaperSetup& setup) {
  std::vector<CandidateRequest> requests;
  for (const CostRow& row : kCosts) {
    LUEUR_TRY(request,
              hierarchical_request("atrium", setup.table_size,
                                   paper_settings({std::string("start=") + row.start,
                                                   "levels=" + std::to_string(row.levels),
                                                   "samples=" + std::to_string(row.samples)})));
    requests.push_back(std::move(request));
  }
  return paper_candidates(session, std::move(requests), setup);
}

report::Table cost_table(const Rounds& rounds, std::span<const Candidate> candidates) {
  report::Table table{"Time of the settings, the first row being 1", {}, {}};
  table.columns = {{"start, levels, samples", "", "", 3}};
  for (const char* what : {"gather", "all"})
    for (const char* who : {"8800 GTS", "GTX 260", "ours"})
      table.columns.push_back({who, "", what, 3});
  for (size_t i = 0; i < std::size(kCosts); ++i) {
    const CostRow& row = kCosts[i];
    const CostRow& base = kCosts[kBase];
    table.rows.push_back(
        {name_of(row), row.gather_ms[0] / base.gather_ms[0], row.gather_ms[1] / base.gather_ms[1],
         in_turn(
             rounds, i, kBase,
             [](const FrameTimes& a, const FrameTimes& b) { return gather_ms(a) / gather_ms(b); }),
         row.total_ms[0] / base.total_ms[0], row.total_ms[1] / base.total_ms[1],
         technique_ratio(rounds, candidates, i, kBase)});
  }
  return table;
}

report::Table claim_table(const Rounds& rounds, std::span<const Candidate> candidates) {
  const auto ratio = [&](size_t a, size_t b) { return technique_ratio(rounds, candidates, a, b); };
  const auto paper = [](size_t a, size_t b, int card) {
    return kCosts[a].total_ms[card] / kCosts[b].total_ms[card];
  };
  const double first_level = in_turn(rounds, kBase, kBase, [](const auto& frame, const auto&) {
    return total_ms(frame.passes, "hierarchical.gather@0") / gather_ms(frame);
  });
  const double gather = in_turn(rounds, kBase, kBase, [&](const auto& frame, const auto&) {
    return gather_ms(frame) / technique_ms(frame.passes, candidates[kBase].technique);
  });
  const double fifth_gather =
      in_turn(rounds, kFiveLevels, kBase,
              [](const FrameTimes& a, const FrameTimes& b) { return gather_ms(a) / gather_ms(b); });
  report::Table table{"What the paper says of them", {}, {}};
  table.columns = {{"", "", "", 3},
                   {"8800 GTS", "", "paper", 3},
                   {"GTX 260", "", "paper", 3},
                   {"ours", "", "", 3}};
  const CostRow& base = kCosts[kBase];
  table.rows = {
      {"first level's share of the gather (figure 7: more than 0.7)", {}, {}, first_level},
      {"gather's share of all", base.gather_ms[0] / base.total_ms[0],
       base.gather_ms[1] / base.total_ms[1], gather},
      {"a fifth level: gather", kCosts[kFiveLevels].gather_ms[0] / base.gather_ms[0],
       kCosts[kFiveLevels].gather_ms[1] / base.gather_ms[1], fifth_gather},
      {"a fifth level: all (under 1.01)", paper(kFiveLevels, kBase, 0),
       paper(kFiveLevels, kBase, 1), ratio(kFiveLevels, kBase)},
      {"half start over quarter start", paper(kBase, kQuarter, 0), paper(kBase, kQuarter, 1),
       ratio(kBase, kQuarter)},
      {"4 times the samples, quarter start", paper(kQuarterMany, kQuarter, 0),
       paper(kQuarterMany, kQuarter, 1), ratio(kQuarterMany, kQuarter)},
      {"4 times the samples, half start", paper(kHalfMany, kBase, 0), paper(kHalfMany, kBase, 1),
       ratio(kHalfMany, kBase)},
      {"quarter start with 256 over half start with 64", paper(kQuarterMany, kBase, 0),
       paper(kQuarterMany, kBase, 1), ratio(kQuarterMany, kBase)},
  };
  return table;
}

}  // namespace

Result<report::FigureSection> costs(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(candidates, cost_candidates(session, setup));
  LUEUR_TRY(rounds, time_in_turn(session, candidates, setup.frames));
  report::FigureSection section;
  section.blocks = {
      report::Paragraph{"atrium at " + std::to_string(setup.table_size.width) + " x " +
                        std::to_string(setup.table_size.height) +
                        ", medians of ratios within each of " + std::to_string(setup.frames) +
                        " rounds. The paper has 1280 x 720, r = 20."},
      cost_table(rounds, candidates), claim_table(rounds, candidates),
      report::Paragraph{
          "Where ours departs: what is not gather weighs more here. Each level costs a pyramid, a "
          "combine and a filter pass, which do not shrink with the samples, and on a device that "
          "runs on the CPU each pass costs a fixed time however few its pixels are. So fewer "
          "pixels or samples save less than in the paper, and a further level adds the fixed time "
          "of its passes; its gather alone adds as little as the paper says."}};
  return section;
}

}  // namespace lueur::cli::hssil
