// SPDX-License-Identifier: MIT
// HSSIL figures 4, 6 and 7.
#include <cmath>
#include <string>

#include "base/try.h"
#include "candidate.h"
#include "image/exposure.h"
#include "image/mask.h"
#include "image/tone_map.h"
#include "paper.h"
#include "picture.h"
#include "timing.h"

namespace lueur::cli::hssil {
namespace {

// The paper's rings go from r to 2 r with r = 20, and each level takes the same number of samples.
const std::vector<std::string> kPaperSettings = {"radius=40", "sample_growth=1"};

// --- figure 4 ------------------------------------------------------------------------------------

constexpr uint32_t kLevels = 4;

double mean_luminance(const ImageF& light, const Mask& surfaces) {
  double sum = 0.0;
  for (size_t i = 0; i < surfaces.counts.size(); ++i)
    if (counts(&surfaces, i)) sum += static_cast<double>(luminance_at(light, i));
  return sum / static_cast<double>(surfaces.pixel_count());
}

// The relative root mean square of a - b over that of b.
double relative_difference(const ImageF& a, const ImageF& b) {
  double difference = 0.0, whole = 0.0;
  for (size_t i = 0; i < b.samples.size(); ++i) {
    const auto d = static_cast<double>(a.samples[i]) - static_cast<double>(b.samples[i]);
    difference += d * d;
    whole += static_cast<double>(b.samples[i]) * static_cast<double>(b.samples[i]);
  }
  return whole > 0.0 ? std::sqrt(difference / whole) : 0.0;
}

// --- figures 6 and 7 -----------------------------------------------------------------------------

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

double gather_ms_of(const FrameTimes& frame) {
  return group_ms(frame, "hierarchical.gather");
}

// Medians over the rounds of what `of` says about the times of two candidates in one round.
template <class Of>
double in_turn(const Rounds& rounds, size_t candidate, size_t base, Of of) {
  std::vector<double> values;
  for (size_t i = 0; i < rounds[candidate].size(); ++i)
    values.push_back(of(rounds[candidate][i], rounds[base][i]));
  return distribution(std::move(values)).median;
}

Result<std::vector<Candidate>> cost_candidates(Session& session, const PaperSetup& setup) {
  std::vector<CandidateRequest> requests;
  for (const CostRow& row : kCosts) {
    std::vector<std::string> settings = kPaperSettings;
    settings.push_back(std::string("start=") + row.start);
    settings.push_back("levels=" + std::to_string(row.levels));
    settings.push_back("samples=" + std::to_string(row.samples));
    LUEUR_TRY(technique, choose_technique("hierarchical", settings));
    requests.push_back({technique.label, "atrium", setup.table_size, std::move(technique)});
  }
  return make_candidates(session, std::move(requests), "", setup.seed);
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
    table.rows.push_back({name_of(row), row.gather_ms[0] / base.gather_ms[0],
                          row.gather_ms[1] / base.gather_ms[1],
                          in_turn(rounds, i, kBase,
                                  [](const FrameTimes& a, const FrameTimes& b) {
                                    return gather_ms_of(a) / gather_ms_of(b);
                                  }),
                          row.total_ms[0] / base.total_ms[0], row.total_ms[1] / base.total_ms[1],
                          in_turn(rounds, i, kBase, [&](const FrameTimes& a, const FrameTimes& b) {
                            return technique_ms(a, candidates[i].technique) /
                                   technique_ms(b, candidates[kBase].technique);
                          })});
  }
  return table;
}

report::Table claim_table(const Rounds& rounds, std::span<const Candidate> candidates) {
  const auto ratio = [&](size_t a, size_t b) {
    return in_turn(rounds, a, b, [&](const FrameTimes& x, const FrameTimes& y) {
      return technique_ms(x, candidates[a].technique) / technique_ms(y, candidates[b].technique);
    });
  };
  const auto paper = [](size_t a, size_t b, int card) {
    return kCosts[a].total_ms[card] / kCosts[b].total_ms[card];
  };
  const double first_level = in_turn(rounds, kBase, kBase, [](const auto& frame, const auto&) {
    return total_ms(frame.passes, "hierarchical.gather@0") / gather_ms_of(frame);
  });
  const double gather = in_turn(rounds, kBase, kBase, [&](const auto& frame, const auto&) {
    return gather_ms_of(frame) / technique_ms(frame, candidates[kBase].technique);
  });
  const double fifth_gather = in_turn(
      rounds, kFiveLevels, kBase,
      [](const FrameTimes& a, const FrameTimes& b) { return gather_ms_of(a) / gather_ms_of(b); });
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

Result<report::FigureSection> levels(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(loaded, load_scene("spot-floor"));
  const float exposure_ev = loaded.scene.exposure_ev.value_or(0.0f);
  std::vector<CandidateRequest> requests;
  for (uint32_t only = 0; only <= kLevels; ++only) {
    std::vector<std::string> settings = kPaperSettings;
    settings.push_back("start=quarter");
    settings.push_back("levels=" + std::to_string(kLevels));
    settings.push_back("only_level=" + std::to_string(only));
    LUEUR_TRY(technique, choose_technique("hierarchical", settings));
    requests.push_back({technique.label, "spot-floor", setup.picture_size, std::move(technique)});
  }
  LUEUR_TRY(candidates, make_candidates(session, std::move(requests), "", setup.seed));

  // One frame with all levels, and one with each alone.
  LUEUR_TRY(whole, render_candidate(session, candidates[0], kAllImages));
  const Mask surfaces = mask_of(as_image(*find_pixels(whole.pixels, "depth"), 1));
  const ImageF all = as_image(*find_pixels(whole.pixels, "indirect"), 3);
  const ImageF composed = as_image(*find_pixels(whole.pixels, "composed"), 3);
  const auto shown = [&](const ImageF& light, float brighter_ev) {
    return to_display(light, exposure_ev + brighter_ev, ToneMap::khronos_neutral);
  };
  report::PictureRow row{
      {}, "spot-floor, quarter start. Indirect light is E/π before albedo, one stop brighter."};
  report::Table table{"Share of the indirect light", {}, {}};
  table.columns = {{"level", "", "", 3}, {"reaches", "px", "", 4}, {"share", "", "", 3}};
  ImageF sum(all.width, all.height, 3);
  const double mean = mean_luminance(all, surfaces);
  for (uint32_t level = 1; level <= kLevels; ++level) {
    LUEUR_TRY(frame, render_candidate(session, candidates[level], {"indirect"}));
    const ImageF light = as_image(*find_pixels(frame.pixels, "indirect"), 3);
    for (size_t i = 0; i < sum.samples.size(); ++i) sum.samples[i] += light.samples[i];
    row.pictures.push_back(
        {shown(light, 1.0f), "Indirect, level " + std::to_string(level) + " only", {}});
    // Quarter start: a pixel of level 1 is four of the picture's.
    table.rows.push_back({std::to_string(level), 80.0 * std::exp2(level),
                          mean > 0.0 ? mean_luminance(light, surfaces) / mean : 0.0});
  }
  row.pictures.push_back({shown(all, 1.0f), "Indirect, all levels", {}});
  row.pictures.push_back({shown(composed, 0.0f), "Final image", {}});
  report::FigureSection section;
  section.blocks = {
      row, table,
      report::Paragraph{"The paper: up-sampling introduces no bias. Here the levels' pictures add "
                        "up to the one of all levels with a relative difference of " +
                        std::to_string(relative_difference(sum, all)) +
                        "; what is left is the rounding of half floats."}};
  return section;
}

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
