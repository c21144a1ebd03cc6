// SPDX-License-Identifier: MIT
// FDP figure 10: fewer pixels or fewer samples.
#include <algorithm>
#include <string>

#include "base/try.h"
#include "paper_parts.h"
#include "picture.h"

namespace lueur::cli::fdp {
namespace {

constexpr char kStartsScene[] = "atrium";
constexpr uint32_t kStartsSeeds = 6;

struct Setup {
  const char* start;
  uint32_t samples;
};
// The last one is not in the figure: the text holds it against the first.
constexpr Setup kSetups[] = {{"half", 64}, {"half", 256}, {"quarter", 64}, {"quarter", 256}};

// Each setup at the size of the pictures, each at half of it, and there every pixel of the rings.
Result<std::vector<Candidate>> make(Session& session, Extent size, Extent half,
                                    const PaperSetup& setup) {
  std::vector<CandidateRequest> requests;
  for (const Extent extent : {size, half})
    for (const Setup& s : kSetups) {
      LUEUR_TRY(request,
                hierarchical_request(
                    kStartsScene, extent,
                    paper_settings({std::string("start=") + s.start, "levels=4", "temporal=0",
                                    "samples=" + std::to_string(s.samples)})));
      request.label += " " + std::to_string(extent.width);
      requests.push_back(std::move(request));
    }
  // As far as quarter start with 4 levels reaches.
  LUEUR_TRY(request, hierarchical_request(kStartsScene, half,
                                          paper_settings({"start=full", "levels=6", "temporal=0",
                                                          "sampling=every_pixel"})));
  requests.push_back(std::move(request));
  return paper_candidates(session, std::move(requests), setup);
}

std::string name_of(const Setup& s) {
  return std::string("Indirect, ") + s.start + " start, " + std::to_string(s.samples) + " samples";
}

}  // namespace

Result<report::FigureSection> starts(Session& session, const PaperSetup& setup) {
  const Extent half{std::max(setup.picture_size.width / 2, 1u),
                    std::max(setup.picture_size.height / 2, 1u)};
  LUEUR_TRY(candidates, make(session, setup.picture_size, half, setup));
  const float exposure_ev = candidates.front().scene->exposure_ev;
  report::PictureRow light{{}, "Incident indirect light, E/π before albedo, one stop brighter."};
  report::PictureRow composed{{}, "atrium, and what indirect light adds to it."};
  for (size_t i = 0; i < std::size(kSetups); ++i) {
    LUEUR_TRY(frame, render_candidate(session, candidates[i], kAllImages));
    const ImageF indirect = as_image(*find_pixels(frame.pixels, "indirect"), 3);
    light.pictures.push_back({shown(indirect, exposure_ev, 1.0f), name_of(kSetups[i]), {}});
    if (i != 1) continue;
    ImageF direct = as_image(*find_pixels(frame.pixels, "source"), 3);
    const ImageF specular = as_image(*find_pixels(frame.pixels, "specular"), 3);
    for (size_t k = 0; k < direct.samples.size(); ++k) direct.samples[k] += specular.samples[k];
    composed.pictures.push_back({shown(direct, exposure_ev), "Direct light only", {}});
    composed.pictures.push_back(
        {shown(as_image(*find_pixels(frame.pixels, "composed"), 3), exposure_ev),
         "Direct and indirect light, half start, 256 samples",
         {}});
  }

  LUEUR_TRY(truth_frame, render_candidate(session, candidates.back(), {"indirect"}));
  const ImageF truth = as_image(*find_pixels(truth_frame.pixels, "indirect"), 3);
  report::Table table{"At " + std::to_string(half.width) + " x " + std::to_string(half.height) +
                          ", against every pixel of the rings at full start",
                      {},
                      {}};
  table.columns = {{"", "", "", 3},
                   {"noise", "of the mean", "", 3},
                   {"off by", "relative", "one frame", 3},
                   {"off by", "relative", std::to_string(kStartsSeeds) + " frames", 3}};
  for (size_t i = 0; i < std::size(kSetups); ++i) {
    LUEUR_TRY(seeds,
              render_seeds(session, candidates[std::size(kSetups) + i], "indirect", kStartsSeeds));
    table.rows.push_back({name_of(kSetups[i]), seeds.noise, relative_difference(seeds.first, truth),
                          relative_difference(seeds.mean, truth)});
  }
  report::FigureSection section;
  section.blocks = {
      composed, light, table,
      report::Paragraph{
          "The paper: a coarser start loses high frequencies, and for the same time a coarser "
          "start with more samples is the better choice, as noise is much more noticeable in "
          "motion than missing detail. Noise is what differs between frames without the filter "
          "over time; what the mean of many frames is off by is detail, and light from beyond the "
          "coarsest ring, which reaches half as far at half start."}};
  return section;
}

}  // namespace lueur::cli::fdp
