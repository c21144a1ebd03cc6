// SPDX-License-Identifier: MIT
#include "paper_sol_parts.h"

#include <algorithm>

#include "base/try.h"
#include "image/tone_map.h"
#include "picture.h"

namespace lueur::cli::sol {

LightSettings lights(uint32_t positive, uint32_t negative,
                     std::initializer_list<std::string> more) {
  LightSettings settings = {"lights=" + std::to_string(positive),
                            "negative_lights=" + std::to_string(negative)};
  settings.insert(settings.end(), more);
  return settings;
}

Result<std::vector<Candidate>> light_candidates(Session& session, const PaperSetup& setup,
                                                const std::string& scene, Extent size,
                                                const std::vector<LightSettings>& settings) {
  std::vector<CandidateRequest> requests;
  for (const LightSettings& one : settings) {
    LUEUR_TRY(request, paper_request("indirect_lights", scene, size, one));
    requests.push_back(std::move(request));
  }
  return paper_candidates(session, std::move(requests), setup);
}

std::string place_and_rounds(const PaperSetup& setup) {
  return std::string(kScene) + " at " + std::to_string(setup.table_size.width) + " x " +
         std::to_string(setup.table_size.height) + ", medians of ratios within each of " +
         std::to_string(setup.frames) +
         " rounds. The paper has a bunny in a box at 640 x 480 on a Quadro FX 5500.";
}

Result<Shown> show(Session& session, Candidate& candidate) {
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
  result.composed =
      shown(as_image(*find_pixels(frame.pixels, "composed"), 3), candidate.scene->exposure_ev);
  return result;
}

Result<std::vector<SampleErrors>> errors_of(Session& session, std::vector<Candidate>& candidates,
                                            const ImageF& truth, const Mask& surfaces) {
  std::vector<SampleErrors> errors;
  for (Candidate& candidate : candidates) {
    LUEUR_TRY(frame, render_candidate(session, candidate, {"indirect"}));
    errors.push_back(
        sample_errors(as_image(*find_pixels(frame.pixels, "indirect"), 3), truth, &surfaces));
  }
  return errors;
}

}  // namespace lueur::cli::sol
