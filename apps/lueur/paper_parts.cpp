// SPDX-License-Identifier: MIT
#include "paper_parts.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/try.h"
#include "image/exposure.h"
#include "image/tone_map.h"
#include "picture.h"

namespace lueur::cli {

Result<CandidateRequest> paper_request(const std::string& technique, const std::string& scene,
                                       Extent size, std::vector<std::string> settings) {
  LUEUR_TRY(chosen, choose_technique(technique, settings));
  std::string label = chosen.label;
  return CandidateRequest{std::move(label), scene, size, std::move(chosen), {}};
}

std::vector<std::string> paper_settings(std::initializer_list<std::string> more) {
  std::vector<std::string> settings = {"radius=40", "sample_growth=1"};
  settings.insert(settings.end(), more);
  return settings;
}

Result<std::vector<Candidate>> paper_candidates(Session& session,
                                                std::vector<CandidateRequest> requests,
                                                const PaperSetup& setup) {
  // What another figure has left, under the same label, is not of the frame before.
  session.context.recorder().forget_history();
  return make_candidates(session, std::move(requests), "", setup.seed, {}, MemoryReport::none);
}

Result<std::vector<Candidate>> candidates_on(
    Session& session, const Scene& scene, const std::string& name, const PaperSetup& setup,
    Extent size, const std::string& technique,
    const std::vector<std::vector<std::string>>& settings) {
  session.context.recorder().forget_history();
  LUEUR_TRY(renderer, Renderer::create(*session.system, session.context, scene));
  const auto shared = std::make_shared<SceneUnderTest>(SceneUnderTest{
      name, triangle_count(scene), {}, scene.exposure_ev.value_or(0.0f), 0, std::move(renderer)});
  std::vector<Candidate> candidates;
  for (const std::vector<std::string>& one : settings) {
    LUEUR_TRY(chosen, choose_technique(technique, one));
    Candidate candidate{chosen.label, shared, std::move(chosen), {}, {}};
    candidate.shot = {.extent = size, .seed = setup.seed};
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

Image8 shown(const ImageF& light, float exposure_ev, float brighter_ev) {
  return to_display(light, exposure_ev + brighter_ev, ToneMap::khronos_neutral);
}

ImageF taken_away(const ImageF& without, const ImageF& with) {
  ImageF difference = without;
  for (size_t i = 0; i < difference.samples.size(); ++i)
    difference.samples[i] = std::max(without.samples[i] - with.samples[i], 0.0f);
  return difference;
}

double mean_luminance(const ImageF& light, const Mask& surfaces) {
  double sum = 0.0;
  for (size_t i = 0; i < surfaces.counts.size(); ++i)
    if (counts(&surfaces, i)) sum += static_cast<double>(luminance_at(light, i));
  const auto pixels = static_cast<double>(surfaces.pixel_count());
  return pixels > 0.0 ? sum / pixels : 0.0;
}

double relative_difference(const ImageF& a, const ImageF& b, const Mask* mask) {
  double difference = 0.0, whole = 0.0;
  for (size_t i = 0; i < b.samples.size(); ++i) {
    if (!counts(mask, i / b.channels)) continue;
    const auto d = static_cast<double>(a.samples[i]) - static_cast<double>(b.samples[i]);
    difference += d * d;
    whole += static_cast<double>(b.samples[i]) * static_cast<double>(b.samples[i]);
  }
  return whole > 0.0 ? std::sqrt(difference / whole) : 0.0;
}

Result<Seeds> render_seeds(Session& session, Candidate& candidate, const std::string& image,
                           uint32_t count, const Mask* mask) {
  LUEUR_CHECK(count >= 2);
  Seeds seeds;
  std::vector<double> sums, squares;
  for (uint32_t i = 0; i < count; ++i) {
    LUEUR_TRY(frame, render_candidate(session, candidate, {image, "depth"}));
    ++candidate.shot.seed;
    ImageF light = as_image(*find_pixels(frame.pixels, image), 3);
    sums.resize(light.samples.size());
    squares.resize(light.samples.size());
    for (size_t k = 0; k < light.samples.size(); ++k) {
      const auto value = static_cast<double>(light.samples[k]);
      sums[k] += value;
      squares[k] += value * value;
    }
    if (i > 0) continue;
    seeds.surfaces = mask_of(as_image(*find_pixels(frame.pixels, "depth"), 1));
    seeds.first = std::move(light);
  }
  candidate.shot.seed -= count;
  seeds.mean = seeds.first;
  double variance = 0.0, whole = 0.0, n = 0.0;
  for (size_t k = 0; k < sums.size(); ++k) {
    const double mean = sums[k] / count;
    seeds.mean.samples[k] = static_cast<float>(mean);
    if (!counts(mask, k / seeds.mean.channels)) continue;
    variance += std::max(squares[k] - count * mean * mean, 0.0) / (count - 1);
    whole += mean;
    n += 1.0;
  }
  seeds.noise = whole > 0.0 ? std::sqrt(variance / n) / (whole / n) : 0.0;
  return seeds;
}

Result<FrameRecord> render_settled(Session& session, Candidate& candidate, uint32_t count,
                                   const ImageNames& images) {
  LUEUR_CHECK(count >= 1);
  for (uint32_t i = 1; i < count; ++i) {
    LUEUR_TRY(frame, render_candidate(session, candidate, {}));
    static_cast<void>(frame);
    ++candidate.shot.seed;
  }
  return render_candidate(session, candidate, images);
}

double gather_ms(const FrameTimes& frame) {
  return group_ms(frame, "hierarchical.gather");
}

double technique_ratio(const Rounds& rounds, std::span<const Candidate> candidates,
                       size_t candidate, size_t base) {
  return in_turn(rounds, candidate, base, [&](const FrameTimes& a, const FrameTimes& b) {
    return technique_ms(a.together, candidates[candidate].technique) /
           technique_ms(b.together, candidates[base].technique);
  });
}

}  // namespace lueur::cli
