// SPDX-License-Identifier: MIT
// SOL's table 2 and figures 4 and 7: what a low resolution saves, and what it changes.
#include <algorithm>
#include <cmath>
#include <string>

#include "base/try.h"
#include "paper_sol_parts.h"

namespace lueur::cli::sol {
namespace {

// Of what is shown, in shares of white.
double rms(const Image8& a, const Image8& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.samples.size(); ++i) {
    const double d = (int{a.samples[i]} - int{b.samples[i]}) / 255.0;
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(std::max(a.samples.size(), size_t{1})));
}

struct ShareRow {
  double low_share, rms, frames_a_second;
};
constexpr ShareRow kShares[] = {
    {1.0, 0.015082, 42.5}, {0.875, 0.001688, 26.5}, {0.5, 0.000885, 15.4}, {0.0, 0.0, 12.6}};
constexpr size_t kAllLow = 0, kMostLow = 1, kAllFull = std::size(kShares) - 1;

std::string discontinuity(double threshold) {
  return "discontinuity=" + std::to_string(threshold);
}

// The setting at which this share of the pixels is low: it grows with the threshold. `trial` is a
// candidate to try them with.
Result<std::string> setting_for(Session& session, Candidate& trial, const ShareRow& row) {
  if (row.low_share == 0.0) return std::string("low_resolution=none");
  if (row.low_share == 1.0) return discontinuity(4.0);
  constexpr int kSteps = 8;
  double low = std::log(1e-4), high = std::log(1.0);
  for (int i = 0; i < kSteps; ++i) {
    const double middle = 0.5 * (low + high);
    LUEUR_TRY_VOID(change(trial.technique, "--set", discontinuity(std::exp(middle))));
    LUEUR_TRY(one, show(session, trial));
    (one.low_share < row.low_share ? low : high) = middle;
  }
  return discontinuity(std::exp(0.5 * (low + high)));
}

}  // namespace

Result<report::FigureSection> low_resolution(Session& session, const PaperSetup& setup) {
  // Which pixels are low does not depend on the lights. All show one scene, as loading it takes
  // longer than most of the frames.
  std::vector<LightSettings> settings(std::size(kShares), lights(300, 150));
  settings.push_back(lights(1, 0, {"light_view_px=16"}));
  LUEUR_TRY(candidates, light_candidates(session, setup, kScene, setup.table_size, settings));
  std::vector<std::string> names;
  for (size_t i = 0; i < std::size(kShares); ++i) {
    LUEUR_TRY(found, setting_for(session, candidates.back(), kShares[i]));
    LUEUR_TRY_VOID(change(candidates[i].technique, "--set", found));
    candidates[i].label = candidates[i].technique.label;
    names.push_back(found);
    if (setup.stop.stop_requested()) return report::FigureSection{};
  }
  candidates.pop_back();
  LUEUR_TRY(rounds, time_in_turn(session, candidates, setup.frames));
  std::vector<Shown> all;
  for (Candidate& candidate : candidates) {
    LUEUR_TRY(one, show(session, candidate));
    all.push_back(std::move(one));
  }

  report::Table table{"What is gathered at low resolution, and what that changes", {}, {}};
  table.columns = {{"", "", "", 3}};
  const auto add = [&](const char* group, const char* unit, int digits) {
    for (const char* who : {"paper", "ours"}) table.columns.push_back({who, unit, group, digits});
  };
  add("low share", "", 3);
  add("RMS of the picture", "%", 4);
  add("frames a second", "", 3);
  table.columns.push_back({"RMS of the indirect light", "%", "", 3});
  for (size_t i = 0; i < std::size(kShares); ++i) {
    const ShareRow& row = kShares[i];
    table.rows.push_back({names[i], row.low_share, all[i].low_share, 100.0 * row.rms,
                          100.0 * rms(all[i].composed, all[kAllFull].composed),
                          row.frames_a_second / kShares[kAllFull].frames_a_second,
                          1.0 / technique_ratio(rounds, candidates, i, kAllFull),
                          100.0 * relative_difference(all[i].light, all[kAllFull].light)});
  }
  report::PictureRow pictures{
      {{all[kAllLow].composed, "Low resolution for all pixels", {}},
       {all[kMostLow].composed, "Low resolution for seven of eight pixels", {}},
       {all[kMostLow].gathered, "White: gathered at full resolution", {}},
       {all[kAllFull].composed, "Full resolution for all pixels", {}}},
      "Figures 4 and 7."};
  report::FigureSection section;
  section.blocks = {
      report::Paragraph{place_and_rounds(setup)}, table, pictures,
      report::Paragraph{
          "Frames a second are relative to full resolution; the RMS is of what is shown, in "
          "parts of white. Ours is interpolated from those of four neighbours whose surface is the "
          "pixel's, where the paper's is up-sampled, so that flat walls need no second look."}};
  return section;
}

}  // namespace lueur::cli::sol
