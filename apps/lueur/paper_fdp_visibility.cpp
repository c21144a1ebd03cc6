// SPDX-License-Identifier: MIT
// FDP figure 7: indirect light without and with visibility, and what that takes away.
#include <algorithm>
#include <string>

#include "base/try.h"
#include "paper_parts.h"
#include "picture.h"
#include "reference_trace.h"

namespace lueur::cli::fdp {
namespace {

constexpr char kMarchScene[] = "table";
constexpr uint32_t kFrames = 4;
constexpr uint32_t kTruthDivisor = 8;  // of the picture's size, for the traced share

struct Variant {
  const char* name;
  std::vector<std::string> settings;
};

// The first one is without visibility; the second is shown.
std::vector<Variant> variants() {
  const std::string on = "visibility=first_bounce", own = "visibility_finer=0",
                    many = "visibility_steps=32";
  return {{"", {"visibility=none"}},
          {"finest voxels, 32 steps", {on, many}},
          {"finest voxels, 8 steps (default)", {on}},
          {"voxels of the samples' level, as the paper, 32 steps", {on, own, many}},
          {"voxels of the samples' level, 8 steps", {on, own}}};
}

std::vector<report::Cell> row_of(const std::string& name, const ImageF& without, const ImageF& with,
                                 const Mask& surfaces) {
  const double all = mean_luminance(without, surfaces);
  return {name, all > 0.0 ? 1.0 - mean_luminance(with, surfaces) / all : 0.0};
}

// The same by rays, from the light that the camera sees: with and without what stands between.
Result<std::vector<report::Cell>> traced_row(const PaperSetup& setup) {
  LUEUR_TRY(loaded, load_scene(kMarchScene));
  const reference::Shot shot{std::max(setup.picture_size.width / kTruthDivisor, 1u),
                             std::max(setup.picture_size.height / kTruthDivisor, 1u), 0, 0.0f};
  const auto trace = [&](reference::Mode mode, uint32_t spp) {
    return trace_reference(loaded.scene, shot,
                           {.mode = mode, .bounces = 1, .spp = spp, .seed = setup.seed},
                           std::string(reference::name_of(mode)), setup.stop, setup.cache);
  };
  LUEUR_TRY(with, trace(reference::Mode::screen, setup.spp));
  LUEUR_TRY(without, trace(reference::Mode::screen_unoccluded, 0));
  if (setup.stop.stop_requested()) return std::vector<report::Cell>{};
  return row_of("traced, what the camera sees", *find_layer(without.rendering, "indirect"),
                *find_layer(with.rendering, "indirect"),
                mask_of(*find_layer(with.rendering, "depth")));
}

}  // namespace

Result<report::FigureSection> visibility(Session& session, const PaperSetup& setup) {
  const std::vector<Variant> all = variants();
  std::vector<CandidateRequest> requests;
  for (const Variant& variant : all) {
    std::vector<std::string> settings = paper_settings({"start=half", "levels=5"});
    settings.insert(settings.end(), variant.settings.begin(), variant.settings.end());
    LUEUR_TRY(request, hierarchical_request(kMarchScene, setup.picture_size, std::move(settings)));
    requests.push_back(std::move(request));
  }
  LUEUR_TRY(candidates, paper_candidates(session, std::move(requests), setup));
  const float exposure_ev = candidates.front().scene->exposure_ev;

  report::PictureRow pictures{{},
                              "table, indirect light only, E/π two stops brighter; half start, 5 "
                              "levels, r = 40, 64 samples a level, " +
                                  std::to_string(kFrames) + " frames of the filter over time."};
  report::Table table{"What obstacles take of the indirect light", {}, {}};
  table.columns = {{"", "", "", 3}, {"share", "", "", 4}};
  ImageF without;
  Mask surfaces;
  for (size_t i = 0; i < all.size(); ++i) {
    // What is not shown need not be smooth: its mean is the same.
    const uint32_t frames = i < 2 ? kFrames : 1;
    LUEUR_TRY(frame, render_settled(session, candidates[i], frames, {"indirect", "depth"}));
    ImageF light = as_image(*find_pixels(frame.pixels, "indirect"), 3);
    if (i == 0) {
      surfaces = mask_of(as_image(*find_pixels(frame.pixels, "depth"), 1));
      pictures.pictures.push_back({shown(light, exposure_ev, 2.0f), "No indirect visibility", {}});
      without = std::move(light);
      continue;
    }
    table.rows.push_back(row_of(all[i].name, without, light, surfaces));
    if (i > 1) continue;
    pictures.pictures.push_back(
        {shown(light, exposure_ev, 2.0f), "With indirect visibility, 32 steps", {}});
    pictures.pictures.push_back({shown(taken_away(without, light), exposure_ev, 4.0f),
                                 "Difference, four times as bright",
                                 {}});
  }
  LUEUR_TRY(traced, traced_row(setup));
  if (setup.stop.stop_requested()) return report::FigureSection{};
  table.rows.push_back(std::move(traced));
  report::FigureSection section;
  section.blocks = {
      pictures, table,
      report::Paragraph{
          "The paper shows that soft indirect shadows appear, without numbers, and says nothing of "
          "steps. The last row is what rays find of the same light at an eighth of the size: all "
          "pixels as sources, and the same ones where a ray finds them. Few steps step over thin "
          "obstacles, the more the farther a sample is; in coarse voxels, solid only where all "
          "pixels below are, they are not there at all."}};
  return section;
}

}  // namespace lueur::cli::fdp
