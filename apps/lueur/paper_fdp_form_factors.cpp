// SPDX-License-Identifier: MIT
// FDP figure 2: the form factor from point to point, equation (3), and from point to disc, (4).
#include <algorithm>
#include <string>

#include "base/try.h"
#include "paper_parts.h"

namespace lueur::cli::fdp {
namespace {

constexpr char kScene[] = "cornell";
constexpr uint32_t kSeeds = 8;

double largest_over_mean(const ImageF& light, const Mask& surfaces) {
  const float largest = *std::max_element(light.samples.begin(), light.samples.end());
  const double mean = mean_luminance(light, surfaces);
  return mean > 0.0 ? static_cast<double>(largest) / mean : 0.0;
}

}  // namespace

Result<report::FigureSection> form_factors(Session& session, const PaperSetup& setup) {
  const uint32_t side = setup.picture_size.height;  // the box is as wide as it is high
  std::vector<CandidateRequest> requests;
  for (const char* form_factor : {"point", "disc"}) {
    LUEUR_TRY(request,
              hierarchical_request(kScene, {side, side},
                                   paper_settings({"start=half", "levels=4", "temporal=0",
                                                   std::string("form_factor=") + form_factor})));
    requests.push_back(std::move(request));
  }
  LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
  const float exposure_ev = candidates.front().scene->exposure_ev;
  LUEUR_TRY(point, render_seeds(session, candidates[0], "indirect", kSeeds));
  LUEUR_TRY(disc, render_seeds(session, candidates[1], "indirect", kSeeds));

  report::Table table{"One frame against the mean of " + std::to_string(kSeeds), {}, {}};
  table.columns = {{"", "", "", 3},
                   {"noise", "of the mean", "", 3},
                   {"brightest / mean", "", "", 3},
                   {"mean, of (4)'s", "", "", 3}};
  const double disc_mean = mean_luminance(disc.mean, disc.surfaces);
  const auto add = [&](const char* name, const Seeds& seeds) {
    table.rows.push_back(
        {name, seeds.noise, largest_over_mean(seeds.first, seeds.surfaces),
         disc_mean > 0.0 ? mean_luminance(seeds.mean, seeds.surfaces) / disc_mean : 0.0});
  };
  add("equation (3), point to point", point);
  add("equation (4), point to disc", disc);
  report::FigureSection section;
  section.blocks = {
      report::PictureRow{
          {{shown(point.first, exposure_ev, 1.0f), "Point to point, equation (3)", {}},
           {shown(disc.first, exposure_ev, 1.0f), "Point to disc, equation (4)", {}}},
          std::string(kScene) +
              ", indirect light only, E/π one stop brighter. 4 levels, half start, r = 40, 64 "
              "samples a level, one frame."},
      table,
      report::Paragraph{"The paper: equation (4) removes the noise, in pictures. Here noise is how "
                        "much a pixel differs from frame to frame without the filter over time, "
                        "the root of the mean variance over the mean."}};
  return section;
}

}  // namespace lueur::cli::fdp
