// SPDX-License-Identifier: MIT
// What SOL's figures have in common: the paper's scene, candidates by their lights, and pictures.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/sample_error.h"
#include "paper_parts.h"
#include "report/figure_page.h"

namespace lueur::cli::sol {

inline constexpr char kScene[] = "floating-object";

// Settings of the technique: so many lights, so many negative ones, and then `more`.
using LightSettings = std::vector<std::string>;
LightSettings lights(uint32_t positive, uint32_t negative,
                     std::initializer_list<std::string> more = {});

// One candidate for each of `settings`, to be timed in turn.
Result<std::vector<Candidate>> light_candidates(Session& session, const PaperSetup& setup,
                                                const std::string& scene, Extent size,
                                                const std::vector<LightSettings>& settings);

// Scene, size and rounds of a table of times.
std::string place_and_rounds(const PaperSetup& setup);

// A picture of one setting: light, what of it was gathered, and all together as it is shown.
struct Shown {
  ImageF light;
  Image8 gathered;
  Image8 composed;
  double low_share = 0.0;  // of the pixels that show a surface
};
Result<Shown> show(Session& session, Candidate& candidate);

// What the candidates' indirect light is off by, in their order.
Result<std::vector<SampleErrors>> errors_of(Session& session, std::vector<Candidate>& candidates,
                                            const ImageF& truth, const Mask& surfaces);

// A table: what is off by how many lights, at an eighth of the pictures' size.
Result<std::vector<report::Block>> errors_by_lights(Session& session, const PaperSetup& setup);

}  // namespace lueur::cli::sol
