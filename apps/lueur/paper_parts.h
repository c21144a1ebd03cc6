// SPDX-License-Identifier: MIT
// What the figures of several papers are made from: pictures of many seeds, measures of how they
// differ, and times as ratios within a round.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "candidate.h"
#include "image/mask.h"
#include "paper.h"
#include "timing.h"

namespace lueur::cli {

// What one candidate is made from: a technique with these settings.
Result<CandidateRequest> paper_request(const std::string& technique, const std::string& scene,
                                       Extent size, std::vector<std::string> settings);
inline Result<CandidateRequest> hierarchical_request(const std::string& scene, Extent size,
                                                     std::vector<std::string> settings) {
  return paper_request("hierarchical", scene, size, std::move(settings));
}

// What both papers' figures have in common, and then `more`: rings from 20 to 40 pixels (HSSIL
// writes r = 20 and 2 r, FDP r = 40 and r / 2), and as many samples at each level.
std::vector<std::string> paper_settings(std::initializer_list<std::string> more);

// make_candidates() for the scene's first camera, without a report of memory.
Result<std::vector<Candidate>> paper_candidates(Session& session,
                                                std::vector<CandidateRequest> requests,
                                                const PaperSetup& setup);

// The same on a scene that is at hand, changed or not, which they share. `name` is what tables call
// it.
Result<std::vector<Candidate>> candidates_on(Session& session, const Scene& scene,
                                             const std::string& name, const PaperSetup& setup,
                                             Extent size, const std::string& technique,
                                             const std::vector<std::vector<std::string>>& settings);

// Light for the page, `brighter_ev` stops over the exposure of the scene.
Image8 shown(const ImageF& light, float exposure_ev, float brighter_ev = 0.0f);

// without - with, as far as that is above 0.
ImageF taken_away(const ImageF& without, const ImageF& with);

// Of the pixels that show a surface; 0 without any.
double mean_luminance(const ImageF& light, const Mask& surfaces);

// The root mean square of a - b over that of b, of the pixels that count; 0 where b is black.
double relative_difference(const ImageF& a, const ImageF& b, const Mask* mask = nullptr);

// Pictures of one candidate that differ by the pattern of samples alone.
struct Seeds {
  ImageF first;
  ImageF mean;
  // Root of the mean variance of a channel over the seeds, over the mean of `mean`: how far one
  // picture is from what any number of them would average to.
  double noise = 0.0;
  Mask surfaces;
};
// Renders `count` >= 2 frames and takes the image of this name, see kAllImages, of each. What
// differs is noise only for a technique that keeps nothing of the frame before. `noise` is that of
// the pixels that count.
Result<Seeds> render_seeds(Session& session, Candidate& candidate, const std::string& image,
                           uint32_t count, const Mask* mask = nullptr);

// Renders `count` frames of further seeds, for what a technique remembers to settle, and gives the
// images of the last one.
Result<FrameRecord> render_settled(Session& session, Candidate& candidate, uint32_t count,
                                   const ImageNames& images);

// --- times

double gather_ms(const FrameTimes& frame);

// Median over the rounds of what `of` says about the times of two candidates in one round. By
// candidate, then by round, as Rounds.
template <class Times, class Of>
double in_turn(const std::vector<std::vector<Times>>& rounds, size_t candidate, size_t base,
               Of of) {
  std::vector<double> values;
  for (size_t i = 0; i < rounds[candidate].size(); ++i)
    values.push_back(of(rounds[candidate][i], rounds[base][i]));
  return distribution(std::move(values)).median;
}

// Of the techniques' times, all passes together.
double technique_ratio(const Rounds& rounds, std::span<const Candidate> candidates,
                       size_t candidate, size_t base);

}  // namespace lueur::cli
