// SPDX-License-Identifier: MIT
// What each level of `hierarchical` contributes: the same figure is in two papers.
#include <cmath>
#include <string>

#include "base/try.h"
#include "paper_parts.h"
#include "picture.h"

namespace lueur::cli {
namespace {

constexpr uint32_t kLevels = 4;

}  // namespace

Result<report::FigureSection> level_shares(Session& session, const PaperSetup& setup) {
  std::vector<CandidateRequest> requests;
  for (uint32_t only = 0; only <= kLevels; ++only) {
    LUEUR_TRY(request, hierarchical_request(
                           "spot-floor", setup.picture_size,
                           paper_settings({"start=quarter", "levels=" + std::to_string(kLevels),
                                           "only_level=" + std::to_string(only)})));
    requests.push_back(std::move(request));
  }
  LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
  const float exposure_ev = candidates.front().scene->exposure_ev;

  // One frame with all levels, and one with each alone.
  LUEUR_TRY(whole, render_candidate(session, candidates[0], kAllImages));
  const Mask surfaces = mask_of(as_image(*find_pixels(whole.pixels, "depth"), 1));
  const ImageF direct = as_image(*find_pixels(whole.pixels, "source"), 3);
  const ImageF all = as_image(*find_pixels(whole.pixels, "indirect"), 3);
  const ImageF composed = as_image(*find_pixels(whole.pixels, "composed"), 3);
  report::PictureRow row{
      {{shown(direct, exposure_ev), "Direct light", {}}},
      "spot-floor, quarter start. Indirect light is E/π before albedo, one stop brighter."};
  report::Table table{"Share of the indirect light", {}, {}};
  table.columns = {{"level", "", "", 3}, {"reaches", "px", "", 4}, {"share", "", "", 3}};
  ImageF sum(all.width, all.height, 3);
  const double mean = mean_luminance(all, surfaces);
  for (uint32_t level = 1; level <= kLevels; ++level) {
    LUEUR_TRY(frame, render_candidate(session, candidates[level], {"indirect"}));
    const ImageF light = as_image(*find_pixels(frame.pixels, "indirect"), 3);
    for (size_t i = 0; i < sum.samples.size(); ++i) sum.samples[i] += light.samples[i];
    row.pictures.push_back({shown(light, exposure_ev, 1.0f),
                            "Indirect, level " + std::to_string(level) + " only",
                            {}});
    // Quarter start: a pixel of level 1 is four of the picture's.
    table.rows.push_back({std::to_string(level), 80.0 * std::exp2(level),
                          mean > 0.0 ? mean_luminance(light, surfaces) / mean : 0.0});
  }
  row.pictures.push_back({shown(all, exposure_ev, 1.0f), "Indirect, all levels", {}});
  row.pictures.push_back({shown(composed, exposure_ev), "Final image", {}});
  report::FigureSection section;
  section.blocks = {
      row, table,
      report::Paragraph{"HSSIL: up-sampling introduces no bias; FDP: the levels blend smoothly and "
                        "continuously. Here the levels' pictures add up to the one of all levels "
                        "with a relative difference of " +
                        std::to_string(relative_difference(sum, all)) +
                        "; what is left is the rounding of half floats."}};
  return section;
}

}  // namespace lueur::cli
