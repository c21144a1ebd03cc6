// SPDX-License-Identifier: MIT
// FDP figure 9 (8 in its text): what settings cost, level by level, without and with visibility.
#include <array>
#include <iterator>
#include <optional>
#include <string>

#include "base/try.h"
#include "paper_parts.h"

namespace lueur::cli::fdp {
namespace {

constexpr uint32_t kMostLevels = 5;

// Milliseconds by the rows of the paper's table. "SSIL" is the gather; a level of 0 is not there.
struct Times {
  double voxels_ms = 0;
  std::array<double, kMostLevels> level_ms{};
  double ssil_ms = 0, upsampling_ms = 0, all_ms = 0;
  double pyramid_ms = 0;  // not in the paper
};

// On a GTX 260 at 1280 x 720, r = 40, all sums being the paper's own.
struct Setting {
  const char* start;
  uint32_t levels, samples;
  Times without, with;  // visibility
};
constexpr Setting kSettings[] = {
    {"quarter",
     4,
     64,
     {0, {4.74, 1.25, 0.41, 0.21}, 6.61, 3.23, 9.84},
     {4.5, {27.9, 11.78, 6.18, 0.74}, 50.24, 3.24, 58}},
    {"quarter",
     4,
     256,
     {0, {17.5, 4.61, 1.46, 0.74}, 24.3, 3.23, 27.58},
     {4.5, {103, 43.3, 24.8, 16.1}, 187.9, 3.23, 194}},
    {"half",
     4,
     64,
     {0, {19.1, 5.06, 1.34, 0.43}, 25.9, 3.68, 29.6},
     {4.5, {78.2, 29.3, 11.8, 6.28}, 125, 3.68, 131}},
    {"half",
     5,
     64,
     {0, {19.12, 5.06, 1.34, 0.43, 0.23}, 26.2, 3.72, 29.9},
     {4.5, {78.21, 29.3, 11.8, 6.27, 4.3}, 129, 3.72, 136}},
};
constexpr size_t kQuarter = 0, kQuarterMany = 1, kHalf = 2, kHalfFive = 3;

// How rays march: ours by default, and as in the paper.
enum class March : uint8_t { none, finest, own_level };

// A column of the paper's table, and of those with another march.
struct Column {
  size_t setting;
  March march;
  bool operator==(const Column&) const = default;
};
constexpr Column kColumns[] = {
    {kQuarter, March::none},       {kQuarter, March::finest},  {kQuarterMany, March::none},
    {kQuarterMany, March::finest}, {kHalf, March::none},       {kHalf, March::finest},
    {kHalfFive, March::none},      {kHalfFive, March::finest}, {kQuarter, March::own_level}};

std::optional<size_t> index_of(const Column& column) {
  for (size_t i = 0; i < std::size(kColumns); ++i)
    if (kColumns[i] == column) return i;
  return std::nullopt;
}

const Times& paper_times(const Column& column) {
  const Setting& s = kSettings[column.setting];
  return column.march == March::none ? s.without : s.with;
}

Result<std::vector<Candidate>> cost_candidates(Session& session, const PaperSetup& setup) {
  std::vector<CandidateRequest> requests;
  for (const Column& column : kColumns) {
    const Setting& s = kSettings[column.setting];
    std::vector<std::string> settings =
        paper_settings({std::string("start=") + s.start, "levels=" + std::to_string(s.levels),
                        "samples=" + std::to_string(s.samples)});
    if (column.march != March::none) settings.emplace_back("visibility=first_bounce");
    if (column.march == March::own_level) settings.emplace_back("visibility_finer=0");
    LUEUR_TRY(request, hierarchical_request("atrium", setup.table_size, std::move(settings)));
    requests.push_back(std::move(request));
  }
  return paper_candidates(session, std::move(requests), setup);
}

Times times_of(const FrameTimes& frame, const ChosenTechnique& technique) {
  Times times;
  times.voxels_ms = total_ms(frame.together, "voxels.");
  for (uint32_t level = 0; level < kMostLevels; ++level)
    times.level_ms[level] = total_ms(frame.passes, "hierarchical.gather@" + std::to_string(level));
  times.ssil_ms = gather_ms(frame);
  times.pyramid_ms = group_ms(frame, "hierarchical.pyramid");
  times.all_ms = technique_ms(frame.together, technique);
  times.upsampling_ms = technique_ms(frame.passes, technique) - times.ssil_ms -
                        total_ms(frame.passes, "voxels.") - times.pyramid_ms;
  return times;
}

using Of = double (*)(const Times&);
double level_1(const Times& t) {
  return t.level_ms[0];
}
double ssil(const Times& t) {
  return t.ssil_ms;
}
double upsampling(const Times& t) {
  return t.upsampling_ms;
}
double voxels(const Times& t) {
  return t.voxels_ms;
}
double all(const Times& t) {
  return t.all_ms;
}

// By column, then by round.
using Measured = std::vector<std::vector<Times>>;

// `of` one column over `base_of` of another: the paper's, and ours where that was measured.
double paper_ratio(const Column& column, Of of, const Column& base, Of base_of) {
  return of(paper_times(column)) / base_of(paper_times(base));
}
report::Cell ratio(const Measured& measured, const Column& column, Of of, const Column& base,
                   Of base_of) {
  const std::optional<size_t> a = index_of(column), b = index_of(base);
  if (!a || !b) return {};
  return in_turn(measured, *a, *b,
                 [&](const Times& x, const Times& y) { return of(x) / base_of(y); });
}

// Rows of the paper's table with or without visibility; each cell over all of the first column.
report::Table cost_table(const Measured& measured, March march) {
  constexpr Column kFirst{kQuarter, March::none};
  constexpr Of kLevels[kMostLevels] = {level_1, [](const Times& t) { return t.level_ms[1]; },
                                       [](const Times& t) { return t.level_ms[2]; },
                                       [](const Times& t) { return t.level_ms[3]; },
                                       [](const Times& t) { return t.level_ms[4]; }};
  constexpr Of kPyramid = [](const Times& t) { return t.pyramid_ms; };
  std::vector<std::pair<std::string, Of>> rows;
  if (march != March::none) rows.emplace_back("voxel grid", voxels);
  for (uint32_t k = 0; k < kMostLevels; ++k)
    rows.emplace_back("SSIL level " + std::to_string(k + 1), kLevels[k]);
  rows.emplace_back("total SSIL", ssil);
  rows.emplace_back("upsampling + TC", upsampling);
  rows.emplace_back("mipmapping", kPyramid);
  rows.emplace_back("all", all);

  report::Table table{march == March::none ? "Without visibility, all of the first column being 1"
                                           : "With visibility, in the same unit",
                      {{"", "", "", 3}},
                      {}};
  for (const Setting& s : kSettings)
    for (const char* who : {"paper", "ours"})
      table.columns.push_back({who, "",
                               std::string(s.start) + ", " + std::to_string(s.levels) +
                                   " levels, " + std::to_string(s.samples),
                               march == March::none ? 3 : 4});
  for (const auto& [name, of] : rows) {
    std::vector<report::Cell> cells = {name};
    for (size_t i = 0; i < std::size(kSettings); ++i) {
      const Column column{i, march};
      const bool is_there = of(measured[*index_of(column)].front()) > 0.0;
      const double paper = paper_ratio(column, of, kFirst, all);
      report::Cell& cell = cells.emplace_back();
      if (paper > 0.0) cell = paper;
      cells.push_back(is_there ? ratio(measured, column, of, kFirst, all) : report::Cell());
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

// What the paper says, as a quotient of two numbers of its table.
struct Claim {
  const char* name;
  Column column;
  Of of;
  Column base;
  Of base_of;
};
constexpr March kNo = March::none, kYes = March::finest;
constexpr Claim kClaims[] = {
    {"level 1's share of SSIL, quarter start", {kQuarter, kNo}, level_1, {kQuarter, kNo}, ssil},
    {"level 1's share of SSIL, half start", {kHalf, kNo}, level_1, {kHalf, kNo}, ssil},
    {"level 1's share of SSIL, quarter start, visibility",
     {kQuarter, kYes},
     level_1,
     {kQuarter, kYes},
     ssil},
    {"level 1's share of SSIL, half start, visibility",
     {kHalf, kYes},
     level_1,
     {kHalf, kYes},
     ssil},
    {"a fifth level: SSIL", {kHalfFive, kNo}, ssil, {kHalf, kNo}, ssil},
    {"a fifth level: all (“less than 1 %” more)", {kHalfFive, kNo}, all, {kHalf, kNo}, all},
    {"a fifth level: all, visibility", {kHalfFive, kYes}, all, {kHalf, kYes}, all},
    {"256 over 64 samples: SSIL, quarter start", {kQuarterMany, kNo}, ssil, {kQuarter, kNo}, ssil},
    {"256 over 64 samples: all, quarter start", {kQuarterMany, kNo}, all, {kQuarter, kNo}, all},
    {"256 over 64 samples: SSIL, quarter start, visibility",
     {kQuarterMany, kYes},
     ssil,
     {kQuarter, kYes},
     ssil},
    {"visibility: SSIL, quarter start", {kQuarter, kYes}, ssil, {kQuarter, kNo}, ssil},
    {"visibility: SSIL, quarter start, 256 samples",
     {kQuarterMany, kYes},
     ssil,
     {kQuarterMany, kNo},
     ssil},
    {"visibility: SSIL, half start", {kHalf, kYes}, ssil, {kHalf, kNo}, ssil},
    {"visibility: all, quarter start", {kQuarter, kYes}, all, {kQuarter, kNo}, all},
    {"visibility: all, half start", {kHalf, kYes}, all, {kHalf, kNo}, all},
    {"voxel grid's share of all, half start", {kHalf, kYes}, voxels, {kHalf, kYes}, all},
    {"quarter start with 256 over half start with 64: all",
     {kQuarterMany, kNo},
     all,
     {kHalf, kNo},
     all},
    {"quarter start with 256 over half start with 64: all, visibility",
     {kQuarterMany, kYes},
     all,
     {kHalf, kYes},
     all},
    {"half over quarter start: upsampling + TC",
     {kHalf, kNo},
     upsampling,
     {kQuarter, kNo},
     upsampling},
};

report::Table claim_table(const Measured& measured) {
  report::Table table{"What the paper says of them", {}, {}};
  table.columns = {{"", "", "", 3},
                   {"paper", "", "", 4},
                   {"finest voxels", "", "ours", 4},
                   {"own level's voxels", "", "ours", 4}};
  // The same column with the paper's march.
  const auto own_level = [](Column column) {
    if (column.march == March::finest) column.march = March::own_level;
    return column;
  };
  for (const Claim& c : kClaims)
    table.rows.push_back({c.name, paper_ratio(c.column, c.of, c.base, c.base_of),
                          ratio(measured, c.column, c.of, c.base, c.base_of),
                          c.column.march == March::none ? report::Cell()
                                                        : ratio(measured, own_level(c.column), c.of,
                                                                own_level(c.base), c.base_of)});
  return table;
}

}  // namespace

Result<report::FigureSection> costs(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(candidates, cost_candidates(session, setup));
  LUEUR_TRY(rounds, time_in_turn(session, candidates, setup.frames));
  Measured measured(rounds.size());
  for (size_t i = 0; i < rounds.size(); ++i)
    for (const FrameTimes& frame : rounds[i])
      measured[i].push_back(times_of(frame, candidates[i].technique));
  report::FigureSection section;
  section.blocks = {
      report::Paragraph{"atrium at " + std::to_string(setup.table_size.width) + " x " +
                        std::to_string(setup.table_size.height) +
                        ", r = 40, medians of ratios within each of " +
                        std::to_string(setup.frames) +
                        " rounds. SSIL is the gather, TC the filter over time. The paper has a GTX "
                        "260 at 1280 x 720 and Sponza. Its columns do not all add up: level 4 of "
                        "quarter start with 64 samples and visibility has 0.74 ms, where its sum "
                        "wants 4.4."},
      cost_table(measured, March::none), cost_table(measured, March::finest), claim_table(measured),
      report::Paragraph{
          "Where ours departs: rays take at most 8 steps through the finest voxels, however far "
          "they go; the paper's go through the voxels of their samples' level, which takes about "
          "as long here, and it says nothing of steps. As the steps are as many at each level, "
          "level 1 keeps its share with visibility. What is not gather weighs more on a device "
          "that runs on the CPU, as each pass costs a fixed time however few its pixels are, and "
          "its voxel grid is written by the CPU, too."}};
  return section;
}

}  // namespace lueur::cli::fdp
