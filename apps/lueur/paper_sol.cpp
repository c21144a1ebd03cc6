// SPDX-License-Identifier: MIT
// SOL: what lights cost, what a low resolution saves, and what negative lights take away.
#include <algorithm>
#include <cmath>
#include <string>

#include "base/try.h"
#include "image/sample_error.h"
#include "paper_parts.h"
#include "picture.h"
#include "reference_trace.h"

namespace lueur::cli::sol {
namespace {

constexpr char kScene[] = "floating-object";
constexpr char kTechnique[] = "indirect_lights";

std::vector<std::string> lights(uint32_t positive, uint32_t negative,
                                std::initializer_list<std::string> more = {}) {
  std::vector<std::string> settings = {"lights=" + std::to_string(positive),
                                       "negative_lights=" + std::to_string(negative)};
  settings.insert(settings.end(), more);
  return settings;
}

std::string place_and_rounds(const PaperSetup& setup) {
  return std::string(kScene) + " at " + std::to_string(setup.table_size.width) + " x " +
         std::to_string(setup.table_size.height) + ", medians of ratios within each of " +
         std::to_string(setup.frames) +
         " rounds. The paper has a bunny in a box at 640 x 480 on a Quadro FX 5500.";
}

// A picture of one setting: light, what of it was gathered, and all together as it is shown.
struct Shown {
  ImageF light;
  Image8 gathered;
  Image8 composed;
  double low_share = 0.0;  // of the pixels that show a surface
};

Result<Shown> show(Session& session, Candidate& candidate, float exposure_ev) {
  LUEUR_TRY(frame, render_candidate(session, candidate, {"indirect", "depth", "composed"}));
  const Pixels& indirect = *find_pixels(frame.pixels, "indirect");
  const Mask surfaces = mask_of(as_image(*find_pixels(frame.pixels, "depth"), 1));
  Shown result{as_image(indirect, 3), {}, {}, 0.0};
  ImageF gathered(indirect.extent.width, indirect.extent.height, 3);
  double low = 0.0;
  for (size_t i = 0; i < surfaces.counts.size(); ++i) {
    const float share = indirect.samples[4 * i + 3];
    if (!counts(&surfaces, i)) continue;
    std::fill_n(&gathered.samples[3 * i], 3, share);
    low += 1.0 - static_cast<double>(share);
  }
  result.low_share = low / std::max(static_cast<double>(surfaces.pixel_count()), 1.0);
  result.gathered = to_display(gathered, 0.0f, ToneMap::none);
  result.composed = shown(as_image(*find_pixels(frame.pixels, "composed"), 3), exposure_ev);
  return result;
}

// Of what is shown, in shares of white.
double rms(const Image8& a, const Image8& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.samples.size(); ++i) {
    const double d = (int{a.samples[i]} - int{b.samples[i]}) / 255.0;
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(std::max(a.samples.size(), size_t{1})));
}

struct CostRow {
  uint32_t positive, negative;
  double frames_a_second;
};
constexpr CostRow kCosts[] = {{100, 50, 26.5}, {150, 0, 32.6},   {200, 100, 15.6},
                              {300, 0, 19.2},  {300, 150, 11.0}, {450, 0, 13.6}};

struct ShareRow {
  double low_share, rms, frames_a_second;
};
constexpr ShareRow kShares[] = {
    {1.0, 0.015082, 42.5}, {0.875, 0.001688, 26.5}, {0.5, 0.000885, 15.4}, {0.0, 0.0, 12.6}};
constexpr size_t kAllLow = 0, kMostLow = 1, kAllFull = std::size(kShares) - 1;

Result<Candidate> one_candidate(Session& session, const PaperSetup& setup, Extent size,
                                std::vector<std::string> settings) {
  LUEUR_TRY(request, paper_request(kTechnique, kScene, size, std::move(settings)));
  std::vector<CandidateRequest> requests;
  requests.push_back(std::move(request));
  LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
  return std::move(candidates.front());
}

std::string discontinuity(double threshold) {
  return "discontinuity=" + std::to_string(threshold);
}

// The setting at which this share of the pixels is low: it grows with the threshold. `trial` is a
// candidate to try them with.
Result<std::string> settings_for(Session& session, Candidate& trial, const ShareRow& row) {
  if (row.low_share == 0.0) return std::string("low_resolution=none");
  if (row.low_share == 1.0) return discontinuity(4.0);
  constexpr int kSteps = 10;
  double low = std::log(1e-5), high = std::log(4.0);
  for (int i = 0; i < kSteps; ++i) {
    const double middle = 0.5 * (low + high);
    const ChosenTechnique& chosen = trial.technique;
    LUEUR_TRY_VOID(set_from_text(chosen.info->settings, chosen.technique->settings(),
                                 "discontinuity", std::to_string(std::exp(middle))));
    LUEUR_TRY(one, show(session, trial, 0.0f));
    (one.low_share < row.low_share ? low : high) = middle;
  }
  return discontinuity(std::exp(0.5 * (low + high)));
}

// What a setting is off by, against the sum over the same lights with shadow rays.
Result<report::Table> error_table(Session& session, const PaperSetup& setup) {
  report::Table table{"Off by, against the sum with shadow rays for as many lights", {}, {}};
  table.columns = {{"", "", "", 3}};
  for (const char* group : {"relative MSE", "bias"})
    for (const char* heading : {"300, 0", "300, 150", "300, 600"})
      table.columns.push_back({heading, "", group, 3});
  const Extent size{std::max(setup.picture_size.width / 4, 1u),
                    std::max(setup.picture_size.height / 4, 1u)};
  for (const char* scene : {"floating-object", "still-life", "cornell"}) {
    LUEUR_TRY(loaded, load_scene(scene));
    LUEUR_TRY(truth, trace_reference(loaded.scene, {size.width, size.height, 0, 0.0f},
                                     {.mode = reference::Mode::lights, .spp = 300}, "lights",
                                     setup.stop, setup.cache));
    if (setup.stop.stop_requested()) return table;
    const Mask surfaces = mask_of(*find_layer(truth.rendering, "depth"));
    std::vector<CandidateRequest> requests;
    for (const uint32_t negative : {0u, 150u, 600u}) {
      LUEUR_TRY(request, paper_request(kTechnique, scene, size, lights(300, negative)));
      requests.push_back(std::move(request));
    }
    LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
    std::vector<report::Cell> errors, biases;
    for (Candidate& candidate : candidates) {
      LUEUR_TRY(frame, render_candidate(session, candidate, {"indirect"}));
      const SampleErrors found = sample_errors(as_image(*find_pixels(frame.pixels, "indirect"), 3),
                                               *find_layer(truth.rendering, "indirect"), &surfaces);
      errors.emplace_back(found.rel_mse);
      biases.emplace_back(found.bias);
    }
    std::vector<report::Cell> row = {scene};
    row.insert(row.end(), errors.begin(), errors.end());
    row.insert(row.end(), biases.begin(), biases.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Result<report::FigureSection> light_costs(Session& session, const PaperSetup& setup) {
  std::vector<CandidateRequest> requests;
  for (const CostRow& row : kCosts) {
    LUEUR_TRY(request, paper_request(kTechnique, kScene, setup.table_size,
                                     lights(row.positive, row.negative)));
    requests.push_back(std::move(request));
  }
  LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
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
  return section;
}

Result<report::FigureSection> low_resolution(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(exposure_ev, exposure_of(kScene));
  std::vector<CandidateRequest> requests;
  std::vector<std::string> names;
  LUEUR_TRY(trial, one_candidate(session, setup, setup.table_size, lights(1, 0)));
  for (const ShareRow& row : kShares) {
    LUEUR_TRY(found, settings_for(session, trial, row));
    names.push_back(found);
    LUEUR_TRY(request,
              paper_request(kTechnique, kScene, setup.table_size, lights(300, 150, {found})));
    requests.push_back(std::move(request));
    if (setup.stop.stop_requested()) return report::FigureSection{};
  }
  LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
  LUEUR_TRY(rounds, time_in_turn(session, candidates, setup.frames));
  std::vector<Shown> all;
  for (Candidate& candidate : candidates) {
    LUEUR_TRY(one, show(session, candidate, exposure_ev));
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

Result<report::FigureSection> negative_lights(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(exposure_ev, exposure_of(kScene));
  report::PictureRow pictures{{}, "Figures 5 and 6: 300 lights, 150 negative ones."};
  ImageF open;
  for (const uint32_t negative : {0u, 150u}) {
    LUEUR_TRY(candidate, one_candidate(session, setup, setup.picture_size,
                                       lights(300, negative, {"low_resolution=none"})));
    LUEUR_TRY(one, show(session, candidate, exposure_ev));
    pictures.pictures.push_back(
        {shown(one.light, exposure_ev, 1.0f),
         negative == 0 ? "The lights, before albedo, a stop brighter" : "And the negative ones",
         {}});
    if (negative == 0) {
      open = one.light;
    } else {
      for (size_t i = 0; i < open.samples.size(); ++i)
        open.samples[i] = std::max(open.samples[i] - one.light.samples[i], 0.0f);
      pictures.pictures.push_back(
          {shown(open, exposure_ev, 3.0f), "What these take away, four times as bright", {}});
    }
    pictures.pictures.push_back(
        {std::move(one.composed), negative == 0 ? "Without" : "With negative lights", {}});
  }
  LUEUR_TRY(table, error_table(session, setup));
  if (setup.stop.stop_requested()) return report::FigureSection{};
  report::FigureSection section;
  section.blocks = {
      pictures, table,
      report::Paragraph{
          "The paper shows what negative lights change, without numbers. The sums are over lights "
          "that exact rays place, in the same directions, at a quarter of the pictures' size."}};
  return section;
}

}  // namespace lueur::cli::sol
